"""`dynsplines retarget`: a person's walk on a robot of hinges stands, bends, stays in its ranges; maps; bad input."""

import re
import tomllib
from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np
import pytest
import shipped
from figures import ANDROID
from motions import uncleaned
from oracles import kinematics
from rich.console import Console
from texts import read_cases

from dynsplines import cli, import_motion, models, motion
from dynsplines.clean import command as clean_command
from dynsplines.clip.table import MapTable, SurroundingsTable
from dynsplines.errors import UserError
from dynsplines.exchange import formats, gaps
from dynsplines.exchange.skeleton import bvh_file, hierarchy, maps, retarget
from dynsplines.exchange.skeleton.bvh_file import read
from dynsplines.exchange.skeleton.captured_skeleton import CapturedSkeleton
from dynsplines.motion import Bodies, Saved
from dynsplines.scene.compose import figure_spec
from dynsplines.scene.roles import mapped_roles
from dynsplines.solver import quaternion as quat
from dynsplines.system.progress import Progress


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a walk as BVH, and the robot."""
    folder = tmp_path_factory.mktemp("robot")
    saved = shipped.solved("walk_loop")
    formats.export(saved, "bvh", folder / "walk.bvh", fps=15)
    (folder / "android.xml").write_text(ANDROID, encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def walked(files: Path) -> Saved:
    """The walk on the robot."""
    source = clean_command.Source(files / "walk.bvh", str(files / "android.xml"), avoids_self_collision=True)
    return motion.load(clean_command.run(source, files / "out.npz", progress=Progress()))


@pytest.fixture(scope="module")
def captured(files: Path) -> CapturedSkeleton:
    return CapturedSkeleton.of(bvh_file.read(files / "walk.bvh"))


def onto(captured: CapturedSkeleton, text: str) -> tuple[mujoco.MjModel, np.ndarray, tuple[str, ...]]:
    """The model of a text, qpos of the walk on it, and the notes."""
    model = mujoco.MjModel.from_xml_string(text)
    return model, *retarget.onto(captured, model, "walk.bvh")


def saved_as(folder: Path, text: str, qpos: np.ndarray) -> Path:
    """A robot in a folder, and its skeleton's motion of qpos as BVH."""
    (folder / "robot.xml").write_text(text, encoding="utf-8")
    np.savez(folder / "robot.qpos.npz", time=np.arange(len(qpos)) / 30, qpos=qpos)
    return import_motion(folder / "robot.qpos.npz", folder / "robot.xml").export(folder / "robot.bvh", fps=30)


def played(saved: Saved, fps: float = 120.0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times, qpos, and the soles' lowest points (T, 8, 3) [m], by MuJoCo."""
    samples, model = motion.Sampled.of(saved, fps), saved.figure.model
    soles = [i for i in range(model.ngeom) if "_sole_" in model.geom(i).name]
    lowest = [kinematics(model, row).geom_xpos[soles] - [0, 0, 0.01] for row in samples.qpos]
    return samples.time, samples.qpos, np.array(lowest)


@pytest.mark.slow
def test_the_robot_walks_on_the_ground_in_its_ranges(walked):
    time, qpos, soles = played(walked)
    model = walked.figure.model
    assert soles[..., 2].min() > -0.002
    speed = np.linalg.norm(np.gradient(soles, time, axis=0), axis=2)
    low = np.sort(soles[..., 2], axis=1)[:, 0]
    assert np.mean(low < 0.01) > 0.8
    assert np.median(speed.min(axis=1)) < 0.02
    for joint in range(1, model.njnt):
        if model.jnt_limited[joint]:
            values = qpos[:, model.jnt_qposadr[joint]]
            first, last = model.jnt_range[joint]
            assert first - 1e-4 <= values.min() <= values.max() <= last + 1e-4, model.joint(joint).name
    source = shipped.solved("walk_loop").timeline
    far = source.states[-1, 0] - source.states[0, 0]
    assert qpos[-1, 0] - qpos[0, 0] == pytest.approx(0.68 / 0.85 * far, rel=0.2)  # as its legs are long
    assert np.degrees(np.ptp(qpos[:, model.joint("left_knee").qposadr[0]])) > 30


@pytest.mark.slow
def test_a_map_is_obeyed(command, files, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(clean_command, "_clean", lambda recording, *_: uncleaned(recording))
    words = ["retarget", files / "walk.bvh", "--to", files / "android.xml"]
    (tmp_path / "less.toml").write_text('[figure]\nleft_forearm = ""', encoding="utf-8")
    done = command(*words, "--map", "less.toml", "-o", "b.npz")
    assert done.code == 0, done.err
    saved = motion.load(tmp_path / "b.npz")
    elbow = saved.figure.model.joint("left_elbow").qposadr[0]
    assert np.degrees(np.ptp(played(saved)[1][:, elbow])) < 6


PAIR = '<contact><pair geom1="left_sole_0" geom2="floor"/></contact></mujoco>'  # of a floor that the scene has


@pytest.mark.slow
@pytest.mark.parametrize(("words", "told", "bone_map"), read_cases("retarget_words.toml"))
def test_what_cannot_be_retargeted_is_told(command, files, walked, tmp_path, monkeypatch, words, told, bone_map):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "who.toml").write_text(bone_map, encoding="utf-8")
    (tmp_path / "robot.xml").write_text(ANDROID.replace("</mujoco>", PAIR), encoding="utf-8")
    done = command(*words.format(f=files).split())
    assert done.code == 2
    assert told in done.last, done.last
    assert sorted(path.name for path in tmp_path.iterdir()) == ["robot.xml", "who.toml"]


def test_the_map_of_the_human_that_ships_says_what_is_found_without_it():
    """And that of the G1 names its parts by bodies that go down a leg and an arm."""
    model = mujoco.MjModel.from_xml_string(models.figure_text("human"))
    names, parents = hierarchy.names(model)[1:], [int(parent) - 1 for parent in model.body_parentid[1:]]
    said = {name: tomllib.loads(models.map_file(name).read_text(encoding="utf-8")) for name in models.maps()}
    found = {role: names[body] for role, body in mapped_roles(names, parents, {}, "figure").items()}
    assert said["human"] == {"figure": found}
    assert set(said["human"]["figure"]) < set(said["g1"]["figure"])


def test_only_what_nothing_turns_is_said_to_be_kept_at_rest(captured):
    """Not the bodies of a hip that turn one after the other above the thigh."""
    text = ANDROID.replace("<geom", '<body name="antenna"><joint/><geom size=".01"/></body><geom', 1)
    *_, notes = onto(captured, text)
    assert [note for note in notes if "kept at rest" in note] == [
        "without a counterpart in the file, kept at rest: antenna, left_wrist_roll_link, right_wrist_roll_link"
    ]


def test_a_hip_that_holds_the_thigh_aside_keeps_the_leg_upright_if_the_foot_cannot_roll(captured):
    """Its sole would stand on an edge. A foot that rolls comes where the recording has it about the hip."""
    aside = re.sub(
        r'(name="(left|right)_hip_yaw_link")', lambda m: f'{m[1]} pos="0 {"" if m[2] == "left" else "-"}.1 0"', ANDROID
    )
    stiff = re.sub(r'<joint name="\w+_ankle_roll" [^>]*>', "", aside)
    tilt = []
    for text in (aside, stiff):
        model, qpos, _ = onto(captured, text)
        found = Bodies.of(model, qpos, np.zeros((len(qpos), model.nv)))
        down = quat.rotate(found.rotation[:, model.body("left_knee_link").id], np.array([0.0, 0, -1]))
        tilt.append(np.degrees(np.median(np.abs(np.arcsin(down[:, 1])))))
    assert tilt[1] < 0.5 * tilt[0], tilt


def test_a_robot_s_own_skeleton_moves_it_as_before(captured, tmp_path):
    """Its hinges of a hip are apart from each other, as is its thigh from them."""
    text = re.sub(
        r'(name="(left|right)_hip_(roll|yaw)_link")',
        lambda m: f'{m[1]} pos=".02 {"" if m[2] == "left" else "-"}.05 -.04"',
        ANDROID,
    )
    _, qpos, _ = onto(captured, text)
    saved_as(tmp_path, text, qpos)
    again = import_motion(tmp_path / "robot.bvh", tmp_path / "robot.xml").sampled(30).qpos
    np.testing.assert_allclose(np.delete(again, 2, axis=1), np.delete(qpos, 2, axis=1), atol=2e-3)
    assert np.ptp(again[:, 2] - qpos[:, 2]) < 2e-3


def test_legs_that_hang_on_the_world_are_told(captured):
    text = re.sub(r"<freejoint[^>]*>|<body name=.pelvis. pos=.0 0 .79.>", "", ANDROID).replace(
        "</body></worldbody>", "</worldbody>"
    )
    with pytest.raises(UserError, match="the figure's root, 'left_hip_pitch_link', needs a free joint"):
        onto(captured, text)


def in_t_pose(captured: CapturedSkeleton) -> CapturedSkeleton:
    """The same motion of a skeleton that stretches its arms to the sides in the zero pose."""
    outwards = {"left": np.sqrt([0.5, 0.5, 0, 0]), "right": np.sqrt([0.5, 0.5, 0, 0]) * [1, -1, 1, 1]}
    arms = [name.partition("_") for name in captured.names]
    zero = np.array(
        [outwards[side] if part in ("upper_arm", "forearm", "hand") else [1.0, 0, 0, 0] for side, _, part in arms]
    )
    return replace(
        captured,
        offset=quat.rotate(zero[np.maximum(captured.parents, 0)], captured.offset),
        ends={joint: quat.rotate(zero[joint], end) for joint, end in captured.ends.items()},
        rotation=quat.product(captured.rotation, quat.conjugate(zero)),
    )


@pytest.mark.slow
def test_a_robot_that_rests_with_bent_elbows_holds_its_hands_as_one_with_straight_ones(captured):
    """Forearms are straightened in mind before directions are compared; hands are in line with them."""
    captured = in_t_pose(captured)
    bent = re.sub(
        r'(name="(?:left|right)_elbow_link" pos="0 0 -.22")(><joint name="\w+" axis="0 1 0" range=)"-130 2"',
        r'\1 euler="0 -90 0"\2"-40 92"',
        ANDROID,
    )
    assert bent != ANDROID
    seen = []
    for text in (ANDROID, bent):
        model, qpos, _ = onto(captured, text)
        found = Bodies.of(model, qpos, np.zeros((len(qpos), model.nv)))
        wrists = [model.body(f"{side}_wrist_roll_link").id for side in ("left", "right")]
        seen.append((found.position[:, wrists] - found.position[:, :2][:, 1:], found.rotation[:, wrists]))
    np.testing.assert_allclose(seen[0][0], seen[1][0], atol=0.01)
    assert np.degrees(quat.angle_between(seen[0][1], seen[1][1])).max() < 5


@pytest.mark.slow
def test_joints_turn_no_faster_than_they_may(files, command, tmp_path):
    """The walk's knees turn at 6 rad/s and more; held to 4, by MuJoCo's own differences."""
    words, out = (files / "walk.bvh", "--to", files / "android.xml"), tmp_path / "slow.npz"
    done = command("retarget", *words, "--speed-limit", "4rad/s", "-o", out)
    assert done.code == 0, done.err
    saved = motion.load(out)
    samples, model = motion.Sampled.of(saved, 240.0), saved.figure.model
    qvel = np.zeros((len(samples.time) - 1, model.nv))
    for i in range(len(qvel)):
        step = samples.time[i + 1] - samples.time[i]
        mujoco.mj_differentiatePos(model, qvel[i], step, samples.qpos[i], samples.qpos[i + 1])
    assert np.abs(qvel[:, 6:]).max() <= 4.0
    assert np.abs(np.gradient(samples.qpos[:, 7:], samples.time, axis=0)).max() > 3.5


ROLES = [f"{side}_{part}" for side in ("left", "right") for part in ("upper_arm", "forearm", "thigh", "shin", "foot")]


@pytest.fixture(scope="module")
def walk(files: Path) -> Path:
    return files / "walk.bvh"


def foreign(walk: Path, target: Path, *, on_reference: bool) -> dict[str, str]:
    """Writes the walk with numbers for names, if so under a joint that stands still beside a prop; names by role."""
    text, called = walk.read_text(encoding="utf-8"), dict[str, str]()

    def renamed(found: re.Match[str]) -> str:
        called[found[2]] = f"bone{len(called)}"
        return f"{found[1]} {called[found[2]]}"

    text = re.sub(r"(ROOT|JOINT) (\S+)", renamed, text)
    if on_reference:
        channels = "CHANNELS 3 Zrotation Xrotation Yrotation"
        prop = f"JOINT prop\n{{\nOFFSET 9 9 9\n{channels}\nEnd Site\n{{\nOFFSET 0 1 0\n}}\n}}"
        text = text.replace("ROOT", f"ROOT stage\n{{\nOFFSET 0 0 0\n{channels}\n{prop}\nJOINT", 1)
        head, values = text.split("MOTION\n")
        lines = values.splitlines()
        text = "\n".join([f"{head}}}\nMOTION", *lines[:2], *(f"0 0 0 0 0 0 {line}" for line in lines[2:]), ""])
    target.write_text(text, encoding="utf-8")
    return {role: called[role] for role in ROLES}


def test_a_map_of_limbs_is_enough(walk, tmp_path):
    bone_map = foreign(walk, tmp_path / "a.bvh", on_reference=True)
    model = figure_spec("human").compile()
    expected, _ = retarget.onto(CapturedSkeleton.of(read(walk)), model, "walk.bvh")
    with maps.using(MapTable(recording=bone_map)), gaps.allow():
        found = formats.recording(tmp_path / "a.bvh", model=model)
    assert np.ptp(expected[:, 0]) > 0.3
    np.testing.assert_allclose(found.qpos, expected, atol=1e-5)


@pytest.mark.parametrize("verb", [("retarget", "--to"), ("clean", "--figure")])
def test_names_that_are_unknown_are_to_be_mapped(command, walk, tmp_path, monkeypatch, verb):
    monkeypatch.chdir(tmp_path)
    foreign(walk, tmp_path / "a.bvh", on_reference=False)
    done = command(verb[0], "a.bvh", verb[1], "human")
    assert done.code == 2
    assert "bone0, bone1," in done.last and done.last.endswith("name them in a bone map, --map FILE")


def test_clean_uses_a_map(walk, tmp_path, monkeypatch):
    bone_map = foreign(walk, tmp_path / "a.bvh", on_reference=False)
    lines = "".join(f'{role} = "{name}"\n' for role, name in bone_map.items())
    (tmp_path / "m.toml").write_text(f"[recording]\n{lines}", encoding="utf-8")
    received = list[clean_command.Source]()
    monkeypatch.setattr(clean_command, "run", lambda source, *_, **__: received.append(source))
    cli.clean(tmp_path / "a.bvh", figure="human", map_file=tmp_path / "m.toml")
    read_back = clean_command._read(received[0], SurroundingsTable(), Progress(Console(quiet=True)))
    expected, _ = retarget.onto(CapturedSkeleton.of(read(walk)), figure_spec("human").compile(), "walk.bvh")
    np.testing.assert_allclose(read_back.qpos, expected, atol=1e-5)
