"""Figures that stay above the ground without falling, and feet that slide or drag, are violations."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from oracles import kinematics

from dynsplines import inbetween, recordings, solving
from dynsplines.clip.build import Clip
from dynsplines.measure import violation
from dynsplines.measure.violation import Violation

WALKER = """<mujoco><worldbody>{floor}<body name="trunk" pos="0 0 .5"><freejoint name="root"/><geom size=".1"/>
    <body pos="0 0 -.2"><joint name="knee" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0 0 -.2" size=".05"/></body>
    </body></worldbody></mujoco>"""
FLOOR = '<geom type="plane" size="1 1 .1" pos="0 0 .1"/>'


def read(text: str, model: str, folder: Path) -> Clip:
    """A clip whose figure is a model's text."""
    (folder / "it.xml").write_text(model, encoding="utf-8")
    return recordings.from_text('figure = "it.xml"\n' + text, name="it", folder=folder)


def violations(clip: Clip, kind: str) -> list[Violation]:
    """The violations of a kind on the spline through a clip's keyframes, by time."""
    raw = solving.unsolved(clip).motion.raw
    found = [each for each in violation.violations(clip, raw, raw) if each.kind == kind]
    return sorted(found, key=lambda each: (each.time or 0.0, each.name))


def aloft(text: str, model: str, folder: Path) -> list[str]:
    return [each.text for each in violations(read(text, model, folder), "aloft")]


def hung(*heights: float) -> str:
    return "".join(
        f"[[keyframe]]\ntime = {0.5 * k}\nroot = {{position = [0, 0, {z}], rotation = {{rotvec = [0, 0, 0]}}}}\n"
        "joints.knee = 0\n"
        for k, z in enumerate(heights)
    )


def test_a_figure_that_never_comes_down_is_reported(tmp_path):
    (text,) = aloft(hung(1.45, 1.5), WALKER.format(floor=FLOOR), tmp_path)  # its foot is 0.45 m below its origin
    assert text == "keyframe 1 itself: the figure never comes down: lowest point 0.90 m above the floor at 0.00 s"
    (text,) = aloft(hung(1.45, 1.5), WALKER.format(floor=""), tmp_path)  # the stage's floor, at 0
    assert "lowest point 1.00 m above the floor" in text


@pytest.mark.parametrize("heights", [(0.55, 0.55), (0.56, 0.56), (1.0, 0.55), (0.55, 1.0, 0.55)])
def test_a_figure_that_stands_at_some_time_is_not(heights, tmp_path):
    assert aloft(hung(*heights), WALKER.format(floor=FLOOR), tmp_path) == []


def test_nor_is_one_without_gravity(tmp_path):
    text = WALKER.format(floor=FLOOR).replace("<mujoco>", '<mujoco><option gravity="0 0 0"/>')
    assert aloft(hung(1.5, 1.5), text, tmp_path) == []


def thrown(gravity: float) -> str:
    """Keyframes every 0.05 s of a walker that leaves the floor and lands after 0.5 s, falling with `gravity` [m/s²]."""
    times = np.arange(-2, 13) * 0.05
    heights = 0.55 + np.maximum(0.5 * gravity * times * (0.5 - times), 0)
    return "".join(
        f"[[keyframe]]\ntime = {t + 0.1:.2f}\nroot = {{position = [0, 0, {z}], rotation = {{rotvec = [0, 0, 0]}}}}\n"
        "joints.knee = 0\n"
        for t, z in zip(times, heights, strict=True)
    )


@pytest.mark.parametrize(
    ("gravity", "kinds"), [(9.81, []), (12.0, []), (7.0, []), (3.0, ["float"]), (2.0, ["float"]), (20.0, ["float"])]
)
def test_a_figure_that_falls_too_slowly_or_too_fast_floats(gravity, kinds, tmp_path):
    text = thrown(gravity) + '[[penalty]]\nkind = "flight"\nweight = 0\nintervals = [[0, 0.01]]\n'
    floats = violations(read(text, WALKER.format(floor=FLOOR), tmp_path), "float")
    assert [each.kind for each in floats] == kinds
    for each in floats:
        assert each.time is not None
        assert each.amount == pytest.approx(gravity * 0.25**2 / 2, abs=1e-3)
        assert each.time == pytest.approx(0.35)
        assert each.keyframe == (8 if gravity < 9.81 else None)  # a fast fall is no fault of a keyframe


@pytest.mark.slow
@pytest.mark.parametrize(
    ("seconds", "legs"), [(0.45, ""), (0.45, 'others = "rest"'), (0.3, ""), (0.3, 'others = "rest"')]
)
def test_a_jump_with_one_keyframe_in_the_air_falls_freely_or_is_reported(seconds, legs):
    """With 0.3 s on each side of the top, there is no time for a push-off."""
    crouch = (
        'root = {position = [0, 0, 0.75], rotation = {rotvec = [0, 0, 0]}}\nothers = "rest"\n'
        "sites = {left_heel = [-0.055, 0.09, 0], right_heel = [-0.055, -0.09, 0]}\n"
        "bodies = {left_foot = {flat = true}, right_foot = {flat = true}}\n"
    )
    top = f"root.position = [0, 0, 1.2]\n{legs}\n"
    poses = ('others = "rest"\n', crouch, top, crouch, 'others = "rest"\n')
    times = np.cumsum([0, 0.5, seconds, seconds, 0.7])
    rows = "".join(f"[[keyframe]]\ntime = {t:g}\n{pose}" for t, pose in zip(times, poses, strict=True))
    motion = inbetween(recordings.from_text(f'figure = "human"\n{rows}', name="jump"))
    floats = [violation for violation in motion.violations if violation.kind == "float"]
    if seconds < 0.4:
        assert len(floats) == 1
        return
    assert motion.violations == []
    t = np.linspace(-0.1, 0.1, 9)
    height = [centre_of_mass(motion, 0.5 + seconds + after)[2] for after in t]
    assert 2 * np.polyfit(t, height, 2)[0] == pytest.approx(-9.81, abs=1)


def centre_of_mass(motion, t):
    return kinematics(motion.model, motion.at(t)).subtree_com[1]


@pytest.mark.parametrize(("intervals", "kinds"), [("[[0.1, 0.6]]", []), ("[[0.3, 0.4]]", ["float", "float"])])
def test_a_flight_of_the_clip_may_fall_as_it_likes_but_not_beside_it(intervals, kinds, tmp_path):
    text = thrown(2.0) + f'[[penalty]]\nkind = "flight"\nintervals = {intervals}\n'
    floats = violations(read(text, WALKER.format(floor=FLOOR), tmp_path), "float")
    assert [each.kind for each in floats] == kinds


@pytest.mark.slow
def test_a_jump_that_hovers_beside_its_flight_is_reported():
    """Without a crouch, the figure rises slowly, is in free fall around the top, and comes down slowly."""
    rest, top = 'others = "rest"\n', "root.position = [0, 0, 1.2]\n"
    rows = "".join(f"[[keyframe]]\ntime = {t}\n{pose}" for t, pose in ((0, rest), (1.0, top), (2.0, rest)))
    clip = recordings.from_text(f'figure = "human"\n{rows}', name="jump")
    assert clip.context.schedule.flights
    assert [each.kind for each in inbetween(clip).violations] == ["float"]


@pytest.mark.parametrize(
    ("distance", "height", "slides"),
    [
        (0.5, 0.0, True),
        (0.06, 0.0, True),
        (0.04, 0.0, False),
        (0.5, 0.03, True),
        (0.2, 0.03, False),
        (0.5, 0.06, False),
    ],
)
def test_a_foot_that_moves_flat_along_the_ground_slides(distance, height, slides, tmp_path):
    """A human at rest that is moved so far [m] within 0.5 s, so high [m] above the floor."""
    pose = 'others = "rest"\n'
    text = "".join(
        f"[[keyframe]]\ntime = {t}\nroot = {{position = [{x}, 0, {0.93 + height}]}}\n{pose}"
        for t, x in ((0.0, 0.0), (0.5, distance))
    )
    found = violations(recordings.from_text('figure = "human"\n' + text, name="slide"), "slide")
    assert [each.name for each in found] == (["left_foot", "right_foot"] if slides else [])
    for each in found:
        assert each.amount == pytest.approx(distance)
        assert "from 0.00 to 0.50 s" in each.text


@pytest.mark.parametrize(
    ("distance", "height", "drags"), [(0.5, 0.0, True), (0.12, 0.0, True), (0.09, 0.0, False), (0.5, 0.01, False)]
)
def test_toes_that_move_along_the_ground_drag(distance, height, drags):
    """A human on tiptoe is moved so far [m] within 0.5 s; the spheres of the toes are so high [m] above the floor."""
    ankle, toe = np.radians(40), np.array([0.17, -0.061])
    lower = toe @ [np.sin(ankle), -np.cos(ankle)] - 0.061
    pose = "".join(f"joints.{side}_ankle = {{rotvec = [0, 40, 0]}}\n" for side in ("left", "right"))
    text = "".join(
        f"[[keyframe]]\ntime = {t}\nroot = {{position = [{x}, 0, {0.93 + lower + height}]}}\n{pose}others = 'rest'\n"
        for t, x in ((0.0, 0.0), (0.5, distance))
    )
    clip = recordings.from_text('figure = "human"\n' + text, name="drag")
    drag = violations(clip, "drag")
    assert [point.name for point in drag] == (["left_toe", "right_toe"] if drags else [])
    assert not violations(clip, "slide")
    for point in drag:
        assert point.amount == pytest.approx(distance)


def test_a_foot_that_turns_on_its_heel_does_not_slide():
    """A human at rest turns by 60° about the left heel, so that the right foot moves around it."""
    heel, (cos, sin) = np.array([-0.055, 0.09]), (0.5, np.sqrt(0.75))
    after = heel - np.array([[cos, -sin], [sin, cos]]) @ heel
    rows = "".join(
        f"[[keyframe]]\ntime = {t}\nroot = {{position = [{x}, {y}, 0.93], rotation = {{rotvec = [0, 0, {yaw}]}}}}\n"
        'others = "rest"\n'
        for t, (x, y), yaw in ((0, (0, 0), 0), (1, after, 60))
    )
    found = violations(recordings.from_text('figure = "human"\n' + rows, name="turn"), "slide")
    assert [each.name for each in found] == ["right_foot"]
