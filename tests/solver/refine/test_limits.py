"""Hard joint ranges: between samples too, by SciPy; keyframes stay, and so does what is in range."""

from __future__ import annotations

from collections.abc import Sequence

import mujoco
import numpy as np
import pytest
from figures import figure_of
from scipy.spatial.transform import Rotation

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.penalty import joint_ranges
from dynsplines.solver.refine.limits import farthest, limited

FIRST = {
    "joint": '<joint name="first" axis="0 1 0" range="0 120"/>',
    "world": '<joint name="first" type="ball" range="0 120"/>',
}
MODEL = """<mujoco><worldbody><body>{}<geom size=".05"/>
<body pos=".3 0 0"><joint name="slide" type="slide" range="-.1 .1"/><geom size=".05"/></body>
<body pos=".3 0 0" quat=".9 .1 -.2 .3"><joint name="ball" type="ball" range="0 60"/><geom size=".05"/>
<body pos=".1 0 0"><joint name="last" type="ball"/><geom size=".05"/></body></body></body></worldbody></mujoco>"""
TIMES = (0, 0.4, 0.6, 0.9, 1.2, 1.4, 1.5)
FIRSTS = (0, 118, 110, 0, 0, 60, 0)  # on its bound at both ends, and twice in between
SLIDES = (0.1, 0.1, -0.1, -0.1, 0, 0.09, 0)
BALLS = ([0, 0, 0], [60, 0, 0], [0, 59, 0], [0, 20, 0], [0, -60, 0], [0, 0, -20], [0, 0, 60])
ALLOWED = 0.05  # degrees, or hundredths of a millimetre of slides


def quaternion(rotvec: Sequence[float]) -> Array:
    return Rotation.from_rotvec(rotvec, degrees=True).as_quat(scalar_first=True)


@pytest.fixture(params=FIRST)
def raw(request: pytest.FixtureRequest) -> tuple[Figure, Timeline]:
    """A figure of every kind of range, through keyframes between which the spline leaves them all."""
    figure = figure_of(MODEL.format(FIRST[request.param]))
    assert figure.coordinates == request.param
    keys = []
    for i, (time, first, slide, ball) in enumerate(zip(TIMES, FIRSTS, SLIDES, BALLS, strict=True)):
        own = [np.radians(first)] if request.param == "joint" else quaternion([0, first, 0])
        keys.append(Frame.key(time, [*own, slide, *quaternion(ball), *quaternion([0, 30 * (i % 2), 10 * i])]))
    return figure, raw_timeline(figure, keys)


def beyond(figure: Figure, timeline: Timeline) -> dict[str, float]:
    """How far every joint is beyond its range at most [degrees, cm], 8000 times a second."""
    qpos = figure.to_qpos(path_of(timeline).at(np.linspace(0, 1.5, 12001)))
    out = {}
    for i in range(figure.model.njnt):
        joint = figure.model.joint(i)
        (low, high), at = joint.range, joint.qposadr[0]
        if not figure.model.jnt_limited[i]:
            continue
        if joint.type[0] == mujoco.mjtJoint.mjJNT_BALL:
            angle = Rotation.from_quat(qpos[:, at : at + 4], scalar_first=True).magnitude()
            out[joint.name] = float(np.degrees(angle.max() - high))
        else:
            over = max((qpos[:, at] - high).max(), (low - qpos[:, at]).max())
            out[joint.name] = float(np.degrees(over) if joint.name == "first" else 1000 * over)
    return out


def test_no_joint_leaves_its_range_and_keyframes_stay(raw: tuple[Figure, Timeline]) -> None:
    figure, timeline = raw
    before = beyond(figure, timeline)
    assert all(before[name] > 1 for name in ("first", "slide", "ball"))
    found = limited(figure, timeline, joint_ranges(figure))
    assert all(over < ALLOWED for over in beyond(figure, found).values())
    assert farthest(figure, found, joint_ranges(figure)) == []
    assert limited(figure, found, joint_ranges(figure)) is found
    keys = [figure.to_qpos(path_of(line).at(np.array(TIMES))) for line in (timeline, found)]
    np.testing.assert_allclose(keys[1], keys[0], atol=1e-9)


def test_what_hangs_on_a_joint_and_what_is_in_range_continues_as_before(raw: tuple[Figure, Timeline]) -> None:
    figure, timeline = raw
    found = limited(figure, timeline, [r for r in joint_ranges(figure) if r.name == "ball"])
    last, slide = (figure.model.joint(name).qposadr[0] for name in ("last", "slide"))
    t = np.linspace(0, 1.5, 400)
    one, other = (figure.to_qpos(path_of(line).at(t)) for line in (timeline, found))
    np.testing.assert_allclose(other[:, slide], one[:, slide], atol=1e-9)
    turns = [Rotation.from_quat(each[:, last : last + 4], scalar_first=True) for each in (one, other)]
    assert np.degrees((turns[0].inv() * turns[1]).magnitude()).max() < 1.0


@pytest.mark.parametrize("ends", ["free", "periodic", "clamped"])
def test_any_ends(ends: str) -> None:
    figure = figure_of(
        '<mujoco><worldbody><body><joint name="first" range="0 90"/><geom size=".1"/></body></worldbody></mujoco>'
    )
    keys = [Frame.key(t, [np.radians(x)]) for t, x in ((0, 30), (0.3, 90), (0.5, 88), (0.9, 0), (1.5, 30))]
    timeline = raw_timeline(figure, keys, ends, np.zeros((2, 1)))
    assert beyond(figure, timeline)["first"] > 3
    found = limited(figure, timeline, joint_ranges(figure))
    assert beyond(figure, found)["first"] < ALLOWED
    path = path_of(found)
    if ends == "periodic":
        for order in (0, 1, 2):
            assert path.at(np.zeros(1), order)[0] == pytest.approx(path.at(np.array([1.5]), order)[0], abs=1e-6)
    if ends == "clamped":
        assert path.at(np.array([0, 1.5]), 1) == pytest.approx(0, abs=1e-9)


def test_slower_motions_are_changed_by_as_much_at_their_keyframes():
    figure = figure_of(
        '<mujoco><worldbody><body><joint name="first" range="0 90"/><geom size=".1"/></body></worldbody></mujoco>'
    )
    states = []
    for pace in (20.0, 100.0):
        keys = [Frame.key(pace * t, [np.radians(x)]) for t, x in ((0, 30), (0.3, 90), (0.5, 88), (0.9, 0), (1.5, 30))]
        path = path_of(limited(figure, raw_timeline(figure, keys), joint_ranges(figure)))
        states.append(path.at(pace * np.linspace(0, 1.5, 200)))
    np.testing.assert_allclose(states[1], states[0], atol=2e-3)
