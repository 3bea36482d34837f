"""Thinning: the bound holds whatever the motion, and hardly any choice of fewer keyframes would keep it."""

import itertools

import mujoco
import numpy as np
import pytest
from figures import FIGURES, figure_of
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import kinematics
from scipy.interpolate import CubicSpline

from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.edit.thin import Recorded, thin
from dynsplines.solver.figure.figure import Figure

WIDE = (0.08, np.radians(10))  # [m], [rad]


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
    instants, timeline = thin(Recorded(figure, times, qpos, metres, np.radians(degrees)))
    distance, angle = apart_by_mujoco(figure, times, qpos, timeline)
    assert distance <= metres * (1 + 1e-6) + 1e-12
    assert angle <= np.radians(degrees) * (1 + 1e-6) + 1e-7
    np.testing.assert_allclose(timeline.times, times[list(instants)])


def test_a_straight_motion_thins_to_two_keyframes():
    figure = of("every joint")
    times = np.linspace(0, 2, 50)
    qpos = np.tile(figure.model.qpos0, (50, 1))
    qpos[:, 0] += 1.5 * times
    qpos[:, 7] += 0.4 * times  # a hinge
    assert thin(Recorded(figure, times, qpos, 1e-6, 1e-6))[0] == (0, 49)


def test_the_worst_is_reported_with_its_name_and_instant():
    figure = of("every joint")
    times, qpos = recording(figure, 2, count=30)
    recorded = Recorded(figure, times, qpos, *WIDE)
    timeline = recorded.spline(recorded.frames([0, 29]))
    (distance, instant, name), (angle, *_) = recorded.worst(timeline)
    apart = apart_by_mujoco(figure, times, qpos, timeline)
    assert (distance, angle) == pytest.approx(apart, rel=1e-6)
    assert name in {figure.model.body(i).name for i in range(figure.model.nbody)}
    assert 0 < instant < 29


@pytest.mark.parametrize(
    ("name", "tip", "more", "reach"),
    [
        ('name="arm"', "tip of arm", "", 1.0),
        ("", "tip of body 1", '<geom size=".05"/>', 1.0),
        ("", "tip of body 1", '<geom size=".5" pos=".36 0 -.48"/><geom size=".05" pos=".3 0 -.9"/>', 1.1),
    ],
)
def test_a_limb_without_a_site_is_measured_at_its_tip(name, tip, more, reach):
    geoms = f'<geom type="capsule" size=".1" fromto="0 0 0 0 0 -.9"/>{more}'
    figure = figure_of(f"<mujoco><worldbody><body {name}><joint axis='0 1 0'/>{geoms}</body></worldbody></mujoco>")
    times, angles = np.linspace(0, 1, 21), 0.3 * np.sin(np.pi * np.linspace(0, 1, 21))
    recorded = Recorded(figure, times, angles[:, None], *WIDE)
    (distance, instant, where), _ = recorded.worst(recorded.spline(recorded.frames([0, 20])))
    assert (where, instant) == (tip, 10)
    assert distance == pytest.approx(reach * 2 * np.sin(0.15))  # from the rest pose


SWAY = """<mujoco><worldbody><body name="foot"><joint type="slide" axis="1 0 0"/><geom size=".02"/>
<site name="sole" pos="0 0 -.02"/></body></worldbody></mujoco>"""


@pytest.mark.parametrize("ends", ["free", "clamped"])
@pytest.mark.parametrize("seed", range(2))
def test_a_single_joints_motion_has_at_most_one_keyframe_more_than_the_fewest(seed, ends):
    """All choices, one by one; and without any one of its keyframes the bound does not hold."""
    figure, rng, times = (figure_of(SWAY), np.random.default_rng(seed), np.linspace(0, 1, 9))
    bends = CubicSpline(np.linspace(0, 1, 5), rng.normal(size=5), bc_type="clamped" if ends == "clamped" else "natural")
    recorded = Recorded(figure, times, bends(times)[:, None], 0.15, 1.0, ends)
    told: list[str] = []
    kept, _ = thin(recorded, told.append)
    assert holds(recorded, kept)
    assert list(kept) == sorted(set(kept))
    assert (kept[0], kept[-1]) == (0, 8)
    assert len(kept) <= fewest(recorded, len(kept)) + 1
    assert not any(holds(recorded, tuple(k for k in kept if k != gone)) for gone in kept[1:-1])
    assert told
