"""Thinning: the bound holds whatever the motion, and hardly any choice of fewer keyframes would keep it."""

from __future__ import annotations

import itertools

import mujoco
import numpy as np
import pytest
from figures import BALL, BALL_TREE, EVERY_JOINT, FIGURES, ONE_BALL, figure_of
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import kinematics
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.edit.thin import Bound, Recorded, refined, thin
from dynsplines.solver.figure.figure import Figure

WIDE = Bound(0.08, np.radians(10))


def recording(figure: Figure, seed: int, count: int = 14, bends: int = 5) -> tuple[np.ndarray, np.ndarray]:
    """Times (count,) and qpos of a motion that turns every joint this way and that."""
    model, rng = figure.model, np.random.default_rng(seed)
    times = np.linspace(0, 1, count)
    velocity = CubicSpline(np.linspace(0, 1, bends), 0.4 * rng.normal(size=(bends, model.nv)), bc_type="natural")(times)
    qpos = np.tile(model.qpos0, (count, 1))
    for row, move in zip(qpos, velocity, strict=True):
        mujoco.mj_integratePos(model, row, move, 1.0)
    return times, qpos


def of(name: str) -> Figure:
    text, coordinates = FIGURES[name]
    return figure_of(text, coordinates)


def apart_by_mujoco(figure: Figure, times: np.ndarray, qpos: np.ndarray, timeline) -> tuple[float, float]:
    """The largest distance of a body's origin or a site [m] and the largest angle of a body [rad]."""
    distance = angle = 0.0
    between = figure.to_qpos(path_of(timeline).at(times))
    for pair in zip(qpos, between, strict=True):
        data = [kinematics(figure.model, row) for row in pair]
        for one, other in ((data[0].xpos, data[1].xpos), (data[0].site_xpos, data[1].site_xpos)):
            if len(one):
                distance = max(distance, float(np.linalg.norm(one - other, axis=1).max()))
        dots = np.abs(np.sum(data[0].xquat * data[1].xquat, axis=1))
        angle = max(angle, float(2 * np.arccos(np.minimum(dots, 1)).max()))
    return distance, angle


def holds(recorded: Recorded, kept: tuple[int, ...]) -> bool:
    return bool(recorded.excess(recorded.spline(recorded.frames(kept))).max() <= 1 + 1e-9)


def fewest(recorded: Recorded, below: int) -> int:
    """The least number of keyframes that any choice keeps the bound with, or `below` if none has fewer."""
    last = len(recorded.times) - 1
    for inner in range(below - 2):
        if any(holds(recorded, (0, *some, last)) for some in itertools.combinations(range(1, last), inner)):
            return inner + 2
    return below


@pytest.mark.slow
@settings(max_examples=8, deadline=None)
@given(
    name=st.sampled_from(sorted(FIGURES)),
    seed=st.integers(0, 10_000),
    count=st.integers(2, 40),
    metres=st.floats(1e-6, 1.0),
    degrees=st.floats(1e-3, 90.0),
)
def test_the_bound_holds_by_mujocos_kinematics(name, seed, count, metres, degrees):
    figure = of(name)
    times, qpos = recording(figure, seed, count)
    found = thin(Recorded(figure, times, qpos, Bound(metres, np.radians(degrees))))
    distance, angle = apart_by_mujoco(figure, times, qpos, found.timeline)
    assert distance <= metres * (1 + 1e-6) + 1e-12
    assert angle <= np.radians(degrees) * (1 + 1e-6) + 1e-7
    np.testing.assert_allclose(found.timeline.times, times[list(found.instants)])


def test_a_straight_motion_thins_to_two_keyframes():
    figure = of("every joint")
    times = np.linspace(0, 2, 50)
    qpos = np.tile(figure.model.qpos0, (50, 1))
    qpos[:, 0] += 1.5 * times
    qpos[:, 7] += 0.4 * times  # a hinge
    assert thin(Recorded(figure, times, qpos, Bound(1e-6, 1e-6))).instants == (0, 49)


def test_a_bound_of_next_to_nothing_keeps_every_instant():
    figure = of("ball tree, world")
    times, qpos = recording(figure, 1, count=12, bends=12)
    recorded = Recorded(figure, times, qpos, Bound(1e-9, 1e-9))
    found = thin(recorded)
    assert found.instants == tuple(range(12))
    assert recorded.excess(found.timeline).max() < 1


@pytest.mark.parametrize(("distance", "angle"), [(0.0, 1.0), (1.0, 0.0), (-1.0, 1.0), (np.nan, 1.0)])
def test_a_bound_of_nothing_is_refused(distance, angle):
    with pytest.raises(ValueError, match="above 0"):
        Bound(distance, angle)


def test_the_worst_is_reported_with_its_name_and_instant():
    figure = of("every joint")
    times, qpos = recording(figure, 2, count=30)
    recorded = Recorded(figure, times, qpos, WIDE)
    timeline = recorded.spline(recorded.frames([0, 29]))
    distance, angle = recorded.worst(timeline)
    apart = apart_by_mujoco(figure, times, qpos, timeline)
    assert (distance.value, angle.value) == pytest.approx(apart, rel=1e-6)
    assert distance.name in {figure.model.body(i).name for i in range(figure.model.nbody)}
    assert 0 < distance.instant < 29


def test_refining_any_in_between_ends_within_the_bound():
    figure = of("ball tree, joint")
    times, qpos = recording(figure, 4, count=30)
    recorded = Recorded(figure, times, qpos, WIDE)
    calls = []

    def crooked(keys):
        calls.append(len(keys))
        line = recorded.spline(keys)
        return line.with_rows(np.concatenate([line.states, 1.3 * line.end_slope]))

    found = refined(recorded, (0, 29), crooked)
    assert recorded.excess(found.timeline).max() <= 1 + 1e-9
    assert calls == sorted(calls)
    assert calls[-1] == len(found.instants)


@pytest.mark.slow
def test_a_loop_stays_a_loop():
    figure = figure_of(BALL_TREE)
    times = np.linspace(0, 1, 13)
    qpos = np.tile(figure.model.qpos0, (13, 1))
    qpos[:, 0] += 2 * times
    qpos[:, 2] += 0.1 * np.cos(2 * np.pi * times)
    swing = 0.5 * np.sin(2 * np.pi * times)
    qpos[:, 7:11] = np.stack([np.cos(swing), np.sin(swing), 0 * swing, 0 * swing], axis=1)
    recorded = Recorded(figure, times, qpos, Bound(0.02, np.radians(5)), "periodic", (2.0, 0.0, 0.0))
    found = thin(recorded)
    assert found.timeline.ends == "periodic"
    assert {0, 12} < set(found.instants)
    assert len(found.instants) <= fewest(recorded, len(found.instants)) + 1
    assert recorded.excess(found.timeline).max() <= 1
    start, end = (path_of(found.timeline).at([t], 1)[0] for t in (0.0, 1.0))
    np.testing.assert_allclose(start, end, atol=1e-9)


def test_figures_without_names_are_reported_by_number():
    figure = figure_of(EVERY_JOINT.replace('name="tip"', ""), "joint")
    recorded = Recorded(figure, *recording(figure, 0), WIDE)
    assert any(name.startswith("body ") for name in recorded.points[0])


SWAY = """<mujoco><worldbody><body name="foot"><joint type="slide" axis="1 0 0"/><geom size=".02"/>
<site name="sole" pos="0 0 -.02"/></body></worldbody></mujoco>"""


def test_limbs_without_a_site_are_looked_at_to_their_tips():
    arm = """<mujoco><worldbody><body name="upper"><joint type="ball"/>
    <geom type="capsule" size=".03" fromto="0 0 0 0 0 -.3"/>
    <body name="lower" pos="0 0 -.3"><joint axis="0 1 0"/><geom type="capsule" size=".02" fromto="0 0 0 0 0 -.25"/>{}
    </body></body></worldbody></mujoco>"""
    bare, marked = (figure_of(arm.format(site)) for site in ("", '<site name="hand"/>'))
    times, qpos = recording(bare, 0)
    names, links, places = Recorded(bare, times, qpos, WIDE).points
    at = names.index("tip of lower")
    assert bare.links[links[at]].body == bare.model.body("lower").id
    np.testing.assert_allclose(places[:, at], [0, 0, -0.27], atol=1e-9)
    assert set(names) == {"upper", "lower", "tip of lower"}
    assert set(Recorded(marked, times, qpos, WIDE).points[0]) == {"upper", "lower", "hand"}


def test_a_round_limb_about_its_joint_has_no_tip():
    head = """<mujoco><worldbody><body name="neck"><joint type="ball"/><geom size=".05"/>
    <body name="head" pos="0 0 .2"><joint type="ball"/><geom size=".1"/></body></body></worldbody></mujoco>"""
    figure = figure_of(head)
    assert Recorded(figure, *recording(figure, 0), WIDE).points[0] == ("neck", "head")


def test_a_miss_counts_as_a_share_of_the_bound():
    """A foot on a slide whose recording is a line, and an in-between that is 3 mm off it throughout."""
    figure, times = figure_of(SWAY), np.linspace(0, 1, 41)
    recorded = Recorded(figure, times, 0.15 * times[:, None], Bound(0.02, np.radians(5)))
    off = recorded.spline([Frame.key(t, [0.15 * t + 0.003]) for t in (0.0, 1.0)])
    np.testing.assert_allclose(recorded.misses(off)[0], 0.003, rtol=1e-9)
    np.testing.assert_allclose(recorded.misses(off)[1], 0, atol=1e-9)
    np.testing.assert_allclose(recorded.excess(off), 0.003 / 0.02, rtol=1e-9)
    assert recorded.worst(off)[0].value == pytest.approx(0.003)


def test_a_turn_counts_as_a_share_of_the_bounds_angle_whatever_the_signs_of_quaternions():
    figure = figure_of(ONE_BALL)
    times, turn = np.linspace(0, 1, 11), Rotation.random(None, np.random.default_rng(2))
    qpos = np.tile(turn.as_quat(scalar_first=True), (11, 1))
    recorded = Recorded(figure, times, qpos, Bound(1.0, 0.1))
    for angle in (0.01, 0.3, 2.5):
        about = Rotation.from_rotvec(angle * np.array([0.6, 0, 0.8])) * turn
        for sign in (1, -1):
            keys = [Frame.key(t, sign * about.as_quat(scalar_first=True)) for t in (0.0, 1.0)]
            off = recorded.spline(keys)
            np.testing.assert_allclose(recorded.excess(off), angle / 0.1, rtol=1e-6)
            assert recorded.worst(off)[1].value == pytest.approx(angle)


def test_a_loops_splines_travel_and_turn_as_it_does_and_others_need_no_travel():
    figure, times = figure_of(BALL), np.linspace(0, 1, 9)
    about = Rotation.from_rotvec(np.outer(0.7 * times, [0, 0, 1]))
    qpos = np.column_stack([0.5 * times, 0 * times, 1 + 0 * times, about.as_quat(scalar_first=True)])
    frames = [0, 3, 8]
    loop = Recorded(figure, times, qpos, WIDE, "periodic", [0.5, 0, 0], 0.7)
    timeline = loop.spline(loop.frames(frames))
    seam = Seam.of(figure, timeline)
    np.testing.assert_allclose(seam.headings, [0.7])
    np.testing.assert_allclose(seam.travel[:3], [0.5, 0, 0], atol=1e-12)
    assert timeline.ends == "periodic"
    assert seam.discontinuity(path_of(timeline)).max() < 1e-9
    assert loop.excess(timeline).max() < 1
    for ends in ("free", "clamped"):
        other = Recorded(figure, times, qpos, WIDE, ends, [0.5, 0, 0], 0.7)
        found = other.spline(other.frames(frames))
        assert found.ends == ends
        slope = path_of(found).motion(times[[0, -1]])[1 if ends == "clamped" else 2]
        np.testing.assert_allclose(slope, 0, atol=1e-9)


@pytest.mark.parametrize("ends", ["free", "clamped"])
@pytest.mark.parametrize("seed", range(2))
def test_a_single_joints_motion_has_at_most_one_keyframe_more_than_the_fewest(seed, ends):
    """All choices, one by one; and without any one of its keyframes the bound does not hold."""
    figure, rng, times = (
        figure_of(SWAY),
        np.random.default_rng(seed),
        np.linspace(0, 1, 9),
    )
    bends = CubicSpline(np.linspace(0, 1, 5), rng.normal(size=5), bc_type="clamped" if ends == "clamped" else "natural")
    recorded = Recorded(figure, times, bends(times)[:, None], Bound(0.15, 1.0), ends)
    told: list[str] = []
    kept = thin(recorded, told.append).instants
    assert holds(recorded, kept)
    assert list(kept) == sorted(set(kept))
    assert (kept[0], kept[-1]) == (0, 8)
    assert len(kept) <= fewest(recorded, len(kept)) + 1
    assert not any(holds(recorded, tuple(k for k in kept if k != gone)) for gone in kept[1:-1])
    assert told
