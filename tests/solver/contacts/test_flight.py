"""Flights that begin and end between keyframes: free falls through keyframes in the air."""

from __future__ import annotations

import numpy as np
import pytest
from figures import figure_of
from oracles import kinematics

from dynsplines import inbetween, load
from dynsplines.solver.contacts import Stance, flights, stances
from dynsplines.solver.contacts.flight import STRETCHED
from dynsplines.solver.contacts.keyframe_points import KeyframePoints
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.surface import Plane
from dynsplines.solver.surface.points import Point

G = 9.81
FLOOR = Plane("floor", np.zeros(3), np.array([0.0, 0, 1]))
# of the size of an adult, with its centre of mass at the root, 1 m above the sole
HOPPER = """<mujoco><worldbody><body pos="0 0 1"><freejoint name="root"/><geom size=".1" pos="0 0 .5" mass="33"/>
  <geom size=".1" pos="0 0 -.5" mass="33"/>
  <body><joint name="leg" type="slide" axis="0 0 1"/><geom size=".05" pos="0 0 -.95" mass="1e-6"/></body>
</body></worldbody></mujoco>"""
FIGURE = figure_of(HOPPER)
SOLE = tuple(Point(name, 2, np.array([x, 0, -1.0])) for name, x in (("heel", -0.1), ("toe", 0.1)))


def hop(*poses: tuple[float, float, float]) -> tuple[tuple[float, float], ...]:
    """The flights of keyframes at a time, of a root height and with the leg drawn in by some length."""
    keys = raw_timeline(FIGURE, [Frame.key(t, [0, 0, z, 1, 0, 0, 0, drawn]) for t, z, drawn in poses])
    sole = KeyframePoints.of(FIGURE, keys, SOLE, (FLOOR,))
    return flights(1, sole, stances(sole))


def crouch(t: float, z: float = 0.8) -> tuple[float, float, float]:
    return t, z, 1.0 - z


def test_a_leap_over_one_keyframe_takes_the_time_of_its_fall():
    ((first, last),) = hop(crouch(0), (0.45, 1.45, 0.1), crouch(0.9))
    assert first + last == pytest.approx(0.9)
    assert last - first == pytest.approx(2 * np.sqrt(2 * (1.45 - STRETCHED) / G))


@pytest.mark.parametrize(("landing", "end"), [(0.9, 0.8), (1.0, 0.8), (0.95, 0.7), (0.8, 0.8)])
def test_it_falls_through_the_keyframe_with_equal_times_on_the_ground(landing, end):
    ((first, last),) = hop(crouch(0), (0.45, 1.4, 0.1), crouch(landing, end))
    assert first == pytest.approx(landing - last)
    t = np.array([first, 0.45, last])
    parabola = np.polyfit(t, [STRETCHED, 1.4, STRETCHED], 2)
    assert parabola[0] == pytest.approx(-G / 2)


def test_a_leap_over_several_keyframes_falls_through_them():
    ((first, last),) = hop(crouch(0), (0.3, 1.25, 0.1), (0.4, 1.3, 0.1), (0.5, 1.25, 0.1), crouch(0.8))
    assert first + last == pytest.approx(0.8)
    parabola = np.polyfit([0.3, 0.5, last], [1.25, 1.25, STRETCHED], 2)
    assert parabola[0] == pytest.approx(-G / 2)


def test_a_foot_in_the_floor_touches_it():
    deep = [(t, z - 0.02, drawn) for t, z, drawn in (crouch(0), crouch(0.9))]
    assert len(hop(deep[0], (0.45, 1.45, 0.1), deep[1])) == 1


def test_there_is_none_where_the_ground_would_have_to_push_faster_than_a_leap():
    assert hop(crouch(0), (0.28, 1.45, 0.1), crouch(0.56)) == ()


@pytest.mark.parametrize("z", [1.0, STRETCHED - 0.01, 2.1])
def test_there_is_none_at_a_height_that_a_stretched_body_reaches_or_none_leaps(z):
    assert hop(crouch(0), (0.7, z, 0.3), crouch(1.4)) == ()


@pytest.mark.parametrize(("first", "last"), [(0.1, 0.4), (0.5, 0.8)])
def test_there_is_none_while_something_else_carries(first, last):
    leap = crouch(0), (0.45, 1.45, 0.1), crouch(0.9)
    keys = raw_timeline(FIGURE, [Frame.key(t, [0, 0, z, 1, 0, 0, 0, drawn]) for t, z, drawn in leap])
    sole, hand = KeyframePoints.of(FIGURE, keys, SOLE, (FLOOR,)), Point("hand", 1, np.zeros(3))
    assert len(flights(1, sole, ())) == 1
    carried = flights(1, sole, [Stance(hand, first, last, np.zeros(3), np.zeros(3))])
    assert all(end <= first or begin >= last for begin, end in carried)


LEGS = ", ".join(f'{side}_{part} = "free"' for side in ("left", "right") for part in ("hip", "knee", "ankle"))
ARMS = "left_shoulder = {rotvec = [15, 40, 0]}, right_shoulder = {rotvec = [-15, 40, 0]}"
TUCKED = ", ".join(
    f"{side}_{part} = {{rotvec = [0, {angle}, 0]}}"
    for side in ("left", "right")
    for part, angle in (("hip", -30), ("knee", 40), ("shoulder", -100))
)


def crouched(time: float, x: float) -> str:
    return f"""
[[keyframe]]
time = {time}
sites = {{left_heel = [{x}, 0.09, 0], right_heel = [{x}, -0.09, 0]}}
bodies = {{left_foot = {{flat = true}}, right_foot = {{flat = true}}}}
joints = {{{LEGS}, {ARMS}}}
root = {{position = [{x - 0.08}, 0, 0.72], rotation = {{rotvec = [0, 20, 0]}}}}
others = "rest"
"""


LEAP = f"""figure = "human"{crouched(0.0, 0.0)}
[[keyframe]]
time = 0.4
root = {{position = [0.35, 0, 1.3], rotation = {{rotvec = [0, 0, 0]}}}}
joints = {{{TUCKED}}}
others = "rest"
{crouched(0.8, 0.7)}"""


def test_a_person_who_is_keyed_in_crouches_and_at_the_top_leaps_in_free_fall():
    """Between take-off and landing the centre of mass falls as MuJoCo has it, and nothing is reported."""
    clip = load(LEAP)
    ((first, last),) = clip.context.schedule.flights
    motion, model = inbetween(clip), clip.figure.model
    t = np.linspace(first + 0.02, last - 0.02, 40)
    heights = [float(kinematics(model, motion.at(time)).subtree_com[0, 2]) for time in t]
    assert np.polyfit(t, heights, 2)[0] == pytest.approx(-G / 2, rel=0.03)
    assert not motion.violations
