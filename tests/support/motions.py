"""Motions for tests: walks, hops, recordings with faults, motions without symmetry."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

import mujoco
import numpy as np
from figures import biped, figure_of
from texts import read_data

from dynsplines import models, solving
from dynsplines.clip import load as clip
from dynsplines.clip.posing.places import sole_points
from dynsplines.exchange import formats
from dynsplines.exchange.motion_import import read_recording
from dynsplines.exchange.recording import Recording
from dynsplines.measure.bounds import Violation
from dynsplines.measure.violation import violations
from dynsplines.motion import Sampled, Saved
from dynsplines.scene.compose import compose, figure_spec
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.contacts.gait import Gait
from dynsplines.solver.contacts.keyframe_points import KeyframePoints
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.surface import Plane
from dynsplines.solver.surface.points import Point, places_of

# Motions without any symmetry, for tests of formats: a root that travels and turns about all axes, joints anywhere.

FPS = 50.0
ROBOT = read_data("robot.xml")


def motion_of(figure: str, *, seed: int = 3, spread: float = 0.9, start: float = 0.25) -> Saved:
    """The spline through five random keyframes, 0.3 s apart, of a figure as a clip file names it; spread [rad]."""
    model = figure_spec(figure).compile()
    rng = np.random.default_rng(seed)
    qpos = np.tile(model.qpos0, (5, 1))
    qpos[:, :3] += np.cumsum(rng.uniform(-0.2, 0.5, (5, 3)), axis=0)
    qpos[:, 3:7] = quat.from_rotation_vector(rng.uniform(-1.2, 1.2, (5, 3)))
    for joint in range(1, model.njnt):
        at = model.jnt_qposadr[joint]
        turn = spread * rng.uniform(-1, 1, (5, 3))
        if model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_BALL:
            qpos[:, at : at + 4] = quat.from_rotation_vector(turn)
        else:
            qpos[:, at] = turn[:, 0]
    return through(figure, start + 0.3 * np.arange(5), qpos)


def through(figure: str, time: np.ndarray, qpos: np.ndarray) -> Saved:
    """The spline through keyframes."""
    found = clip.from_qpos("wild", compose(figure_spec(figure)), time, qpos, FPS, "wild")
    return solving.raw_spline(found)


def raw_violations(problem: clip.Clip) -> tuple[Violation, ...]:
    """The violations of the raw spline through a clip's keyframes."""
    return violations(problem, solving.raw_spline(problem))


def samples(saved: Saved, fps: float | None = None) -> Sampled:
    return Sampled.of(saved, fps)


def poses(model: mujoco.MjModel, qpos: np.ndarray, qvel: np.ndarray | None = None) -> dict[str, np.ndarray]:
    """MuJoCo's own positions, rotations (matrices) and velocities (spin, then the origin's; world) of every body."""
    data = mujoco.MjData(model)
    out = {"xpos": [], "xmat": [], "velocity": []}
    for i, row in enumerate(qpos):
        data.qpos = row
        data.qvel = 0 if qvel is None else qvel[i]
        mujoco.mj_forward(model, data)
        both = np.zeros((model.nbody, 6))
        for body in range(model.nbody):
            mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_XBODY, body, both[body], 0)
        for name, value in (("xpos", data.xpos), ("xmat", data.xmat), ("velocity", both)):
            out[name].append(np.array(value))
    return {name: np.array(rows) for name, rows in out.items()}


def same_poses(model: mujoco.MjModel, first: np.ndarray, second: np.ndarray, tolerance: float = 1e-9) -> None:
    """Bodies stand in the same places, whatever the signs of quaternions."""
    a, b = poses(model, first), poses(model, second)
    assert a["xpos"].shape == b["xpos"].shape
    np.testing.assert_allclose(a["xpos"], b["xpos"], atol=tolerance)
    np.testing.assert_allclose(a["xmat"], b["xmat"], atol=tolerance)


def exported(saved: Saved, kind: str, folder: Path, **more: Any) -> tuple[Path, list[str]]:
    """The file of a motion in a format, and the lines that are reported."""
    notes: list[str] = []
    target = formats.export(saved, kind, folder / f"out{formats.writer(kind).ending}", report=notes.append, **more)
    return target, notes


def came_back(saved: Saved, target: Path, figure: str | None = "human", tolerance: float = 1e-9, **more: Any) -> None:
    """A file read again brings every body to where it was, at the same times from 0 on."""
    back, before = read_recording(target, figure=figure, **more), samples(saved)
    assert abs(back.rate - saved.fps) < 1e-6
    np.testing.assert_allclose(back.time - back.time[0], before.time - before.time[0], atol=1e-9)
    same_poses(saved.figure.model, before.qpos, back.qpos, tolerance)


# A lopsided figure of every joint and every kind of geom, and a motion of it that turns about no axis of the world.

PUPPET = read_data("puppet.xml")


def moved(fps: float = 24.0, text: str = PUPPET, name: str = "puppet", count: int = 12) -> Saved:
    """Its motion through random configurations, the same at every call; the root turns by more than half a turn."""
    rng = np.random.default_rng(3)
    model = mujoco.MjModel.from_xml_string(text)
    qpos = np.tile(model.qpos0, (count, 1))
    for i in range(model.njnt):
        at, free = int(model.jnt_qposadr[i]), int(model.jnt_type[i]) == int(mujoco.mjtJoint.mjJNT_FREE)
        if free or int(model.jnt_type[i]) == int(mujoco.mjtJoint.mjJNT_BALL):
            turn = np.cumsum(rng.normal([0.25, -0.2, 0.35], 0.2, (count, 3)), axis=0)
            columns = slice(at + 3 * free, at + 3 * free + 4)
            qpos[:, columns] = quat.product(qpos[:, columns], quat.from_rotation_vector(turn))
            if free:
                qpos[:, at : at + 3] += np.cumsum(rng.normal(0.05, 0.1, (count, 3)), axis=0)
        else:
            qpos[:, at] += np.cumsum(rng.normal(0.05, 0.1, count))
    assert np.all(np.ptp(qpos, axis=0) > 0.01)
    spec = mujoco.MjSpec.from_string(text)
    found = clip.from_qpos(name, compose(spec), np.arange(count) / 12.0, qpos, fps, name)
    return solving.raw_spline(found)


def uncleaned(recording: Recording) -> Saved:
    """A recording as it is."""
    assert recording.scene is not None
    parts = recording.name, recording.scene, recording.time, recording.qpos, recording.rate, recording.name
    return solving.raw_spline(clip.from_qpos(*parts))


# A motion as a bad recording has it: it slides, sinks and hovers, shakes, and misses samples.

SLIDE, TURNS_IN = 0.05, 4.0  # [m/s] whose direction goes round once in so many seconds
SINKS, EVERY = 0.02, 1.0  # [m] down and up in turn, [s] each


@dataclass(frozen=True)
class Take:
    """A figure's motion at equal times: time (T,) [s], qpos (T, nq)."""

    figure: Figure
    time: np.ndarray
    qpos: np.ndarray

    @classmethod
    def of(cls, saved: Saved, fps: float) -> Self:
        samples = Sampled.of(saved, fps)
        return cls(saved.figure, samples.time, samples.qpos)

    def sliding(self, rng: np.random.Generator) -> np.ndarray:
        """qpos of a root that slides, sinks and hovers."""
        out, since = self.qpos.copy(), self.time - self.time[0]
        turn = 2 * np.pi / TURNS_IN
        angle = turn * since + rng.uniform(0, 2 * np.pi)
        way = np.stack([np.sin(angle) - np.sin(angle[0]), np.cos(angle[0]) - np.cos(angle)], axis=1)
        out[:, :2] += SLIDE / turn * way
        out[:, 2] += SINKS * np.where(np.floor(since / EVERY) % 2, 1, -1)
        return out

    def shaking(self, qpos: np.ndarray, rng: np.random.Generator, metres: float, radians: float) -> np.ndarray:
        """qpos with white noise on the root's place and every rotation."""
        out = qpos.copy()
        for columns in self.figure.tables.position_columns.T:
            out[:, columns] += rng.normal(0, metres, (len(out), 3))
        for link in self.figure.links[1:]:
            if link.kind.name in ("BALL", "FREE"):
                first = link.qpos + 3 * (link.kind.name == "FREE")
                noise = quat.from_rotation_vector(rng.normal(0, radians, (len(out), 3)))
                out[:, first : first + 4] = quat.product(out[:, first : first + 4], noise)
            elif link.kind.name == "HINGE":
                out[:, link.qpos] += rng.normal(0, radians, len(out))
        return out


# Exported scenes to simulate: written from a motion, and played by `mj_step` with `ctrl` interpolated between keys.


@dataclass(frozen=True)
class Played:
    """A simulated scene.

    data     the state at the end
    last     (nv,) [m, rad] from the keys to the state at the end; quaternions of keys are interpolated linearly
    worst    (nv,) [m, rad] the largest size of that on the way
    deepest  [m] of a contact on the way
    """

    data: mujoco.MjData
    last: Array
    worst: Array
    deepest: float


def clip_file(folder: Path, figure: Path, *keyframes: str) -> Path:
    """A clip of a figure, of the lines of its keyframes."""
    blocks = "".join(f"[[keyframe]]\n{lines}\n" for lines in keyframes)
    (folder / "clip.toml").write_text(f'figure = "{figure}"\n{blocks}')
    return folder / "clip.toml"


def exported_scene(saved: Saved, folder: Path) -> tuple[mujoco.MjModel, list[str]]:
    """The scene of a motion, as folder/out.simulate.xml has it, and the notes of its export."""
    notes: list[str] = []
    path = folder / "out.simulate.xml"
    formats.export(saved, formats.choose(None, path).name, path, report=notes.append)
    return mujoco.MjModel.from_xml_path(str(path)), notes


def between(model: mujoco.MjModel, rows: Array, time: float) -> Array:
    """Rows of a model's keys at a time between them."""
    return np.array([np.interp(time, model.key_time, column) for column in rows.T])


def played(model: mujoco.MjModel, duration: float = np.inf) -> Played:
    """The scene after some time [s] from its first key, or at its last; without numbers if MuJoCo gives up."""
    data, away, worst, deepest = mujoco.MjData(model), np.zeros(model.nv), np.zeros(model.nv), 0.0
    mujoco.mj_resetDataKeyframe(model, data, 0)
    end = min(model.key_time[-1], model.key_time[0] + duration)
    while data.time < end:
        before = data.time
        data.ctrl = between(model, model.key_ctrl, before)
        mujoco.mj_step(model, data)
        if data.time <= before:
            return Played(data, np.full(model.nv, np.inf), np.full(model.nv, np.inf), deepest)
        qpos = between(model, model.key_qpos, data.time)
        mujoco.mj_normalizeQuat(model, qpos)
        mujoco.mj_differentiatePos(model, away, 1, qpos, data.qpos)
        worst = np.maximum(worst, np.abs(away))
        deepest = max([deepest, *(-contact.dist for contact in data.contact)])
    return Played(data, away, worst, deepest)


# Somebody kneels: one foot stands on its toe, whose heel slowly rises; the other stands flat. All of it is known.

SECONDS, RISES_FROM, RISES_UNTIL = 3.2, 0.7, 2.3  # [s]
DROP, FORWARD = 0.25, 0.05  # [m] of the root
TOE = np.array([0.17, -0.061])  # [m] centre of the round tip of the sole from the ankle: x and z


def kneeling(fps: float, pitch: float) -> Take:
    """The human on the left sole and the right toe, whose centres stay; the right foot ends with this pitch [rad]."""
    scene = compose(figure_spec("human"))
    figure = clip.figure_of(scene, "kneeling")
    model = figure.model
    time = np.arange(round(SECONDS * fps) + 1) / fps
    share = np.clip((time - RISES_FROM) / (RISES_UNTIL - RISES_FROM), 0, 1)
    share = share**3 * (10 - 15 * share + 6 * share**2)
    qpos = np.tile(model.qpos0, (time.size, 1))
    qpos[:, 0] += FORWARD * share
    qpos[:, 2] -= DROP * share
    thigh, shin = (-float(model.body(f"left_{below}").pos[2]) for below in ("shin", "foot"))
    for side, tilt in (("left", 0 * share), ("right", pitch * share)):
        ankle = np.array([[0.0], [-thigh - shin]]) + TOE[:, None] - _turned(TOE[:, None], tilt)
        leg = ankle - np.array([FORWARD * share, -DROP * share])
        knee = np.pi - np.arccos((thigh**2 + shin**2 - np.sum(leg**2, axis=0)) / (2 * thigh * shin))
        bent = np.array([-shin * np.sin(knee), -thigh - shin * np.cos(knee)])
        hip = np.arctan2(leg[0], leg[1]) - np.arctan2(bent[0], bent[1])
        hip = np.arctan2(np.sin(hip), np.cos(hip))
        for joint, angle in (("hip", hip), ("knee", knee), ("ankle", tilt - hip - knee)):
            at = model.joint(f"{side}_{joint}").qposadr[0]
            qpos[:, at], qpos[:, at + 2] = np.cos(angle / 2), np.sin(angle / 2)
    return Take(figure, time, qpos)


def _turned(place: np.ndarray, angle: np.ndarray) -> np.ndarray:
    """x and z (2, T) turned about y by angles (T,) [rad]."""
    return np.array(
        [place[0] * np.cos(angle) + place[1] * np.sin(angle), place[1] * np.cos(angle) - place[0] * np.sin(angle)]
    )


# A human that walks, feet flat, at the speed of the standing foot.
#
# Hips go back evenly and forward faster, knees bent meanwhile.

SWING, BENT, ARMS = 0.4, 0.9, 0.4  # [rad] amplitudes
STANCE = 0.62  # of a period
FINE = 400  # samples a second


def walker(coordinates: str = "auto") -> tuple[Figure, tuple[Point, ...]]:
    figure = figure_of(models.figure_text("human"), coordinates)
    return figure, sole_points(figure, np.zeros((0, figure.width)))


def walk(figure: Figure, points: tuple[Point, ...], period: float, seconds: float) -> tuple[np.ndarray, np.ndarray]:
    """Times (T,) [s] and configurations (T, nq)."""
    time = np.arange(round(seconds * FINE) + 1) / FINE
    qpos = np.tile(figure.model.qpos0, (time.size, 1))
    place = {link.name: link.qpos for link in figure.links[1:]}

    def turn(name: str, angle: np.ndarray) -> None:
        about = np.outer(angle, [0.0, 1, 0])
        qpos[:, place[name] : place[name] + 4] = quat.from_rotation_vector(about)

    phase = time / period
    stands = []
    for side, shift in (("left", 0.0), ("right", 0.5)):
        part = (phase + shift) % 1
        swing = np.maximum(part - STANCE, 0) / (1 - STANCE)
        stands.append(swing == 0)
        hip = SWING * np.where(swing == 0, 2 * part / STANCE - 1, np.cos(np.pi * swing))
        knee = 0.1 + BENT * np.sin(np.pi * swing) ** 2
        for name, angle in (("hip", hip), ("knee", knee), ("ankle", -hip - knee)):
            turn(f"{side}_{name}", angle)
        turn(f"{side}_shoulder", -ARMS * np.sin(2 * np.pi * (part + 0.2)))
    state = figure.to_state(qpos)
    places = places_of(points, Samples(figure, state, 0 * state, 0 * state))[0]
    left = np.array(["left" in point.name for point in points])
    back = np.diff(places[0, left].mean(axis=0))[stands[0][1:] & stands[0][:-1]]
    qpos[:, 0] = -np.median(back) * FINE * time
    qpos[:, 2] -= places[2].min(axis=0)
    return time, qpos


# A walk whose gait is to be read.

PERIOD = 1.1
GROUND = (Plane("floor", np.zeros(3), np.array([0.0, 0, 1])),)
FIGURE, SOLES = walker()
TIME, WALK = walk(FIGURE, SOLES, PERIOD, 3.5)


def gait(qpos: np.ndarray, every: float) -> Gait:
    """Keyframes of a fine motion, so far apart [s]."""
    keys = [Frame.key(TIME[k], qpos[k]) for k in range(0, TIME.size, round(every * FINE))]
    return Gait(KeyframePoints.of(FIGURE, raw_timeline(FIGURE, keys), SOLES, GROUND))


# A biped of hinges that walks on the spot of the floor it stands on, with feet that rest while they stand.

WAIST = """<body name="waist" pos="0 0 .1"><joint name="waist_yaw" axis="0 0 1" range="-57 57"/>
  <geom type="box" size=".08 .15 .15" pos="0 0 .2" mass="8"/></body>"""
PELVIS = biped().replace('mass="8"/>', f'mass="8"/>{WAIST}', 1)
TEXT = f'<mujoco model="biped"><worldbody>{PELVIS}</worldbody></mujoco>'
JOINTS = [f"{side}_{part}" for side in ("left", "right") for part in ("hip", "knee", "ankle")]
BIPED_FPS = 50.0
SPEED = 0.6  # [m/s]


def model() -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_string(TEXT)


def biped_walk(count: int = 100, heading: float = 0.6) -> np.ndarray:
    """qpos (T, 14): steps of half a second in the direction of a heading [rad]; a foot rests while it stands."""
    time = np.arange(count) / BIPED_FPS
    out = np.zeros((count, 14))
    along = SPEED * time
    out[:, 0], out[:, 1], out[:, 2] = along * np.cos(heading), along * np.sin(heading), 0.74
    out[:, 3], out[:, 6] = np.cos(heading / 2), np.sin(heading / 2)
    out[:, 7] = 0.3 * np.sin(2 * np.pi * time)
    for leg, start in enumerate((8, 11)):
        phase = (time + 0.5 * leg) % 1.0
        stands = phase < 0.5
        swing = (phase - 0.5) / 0.5
        x = np.where(stands, SPEED * (0.25 - phase), SPEED * (-0.25 + 0.5 * swing))
        lift = np.where(stands, 0.0, 0.05 * np.sin(np.pi * np.clip(swing, 0, 1)))
        out[:, start : start + 3] = _leg(x, 0.04 - (0.74 - 0.05) + lift)
    return out


def _leg(x: np.ndarray, z: np.ndarray) -> np.ndarray:
    """(T, 3) hip, knee and ankle, so that the ankle is at (x, z) [m] from the hip and the foot is level."""
    reach = np.hypot(x, z)
    knee = np.pi - np.arccos((0.35**2 + 0.36**2 - reach**2) / (2 * 0.35 * 0.36))
    toward = np.arctan2(-x, -z)
    hip = toward - np.arcsin(0.36 * np.sin(knee) / reach)
    return np.stack([hip, knee, -(hip + knee)], axis=1)
