"""Keyframes that stand on both feet at different places: the feet step in turn, or a note says why not."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from gradients import penalty_slope
from oracles import tracks

from dynsplines import Motion, inbetween, recordings
from dynsplines.solver.array import Array
from dynsplines.solver.contacts.footsteps import Footsteps
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.penalty import Attachment


def clip(forward: float, left: float = 0.0, turn: float = 0.0, time: float = 1.2, more: str = "") -> str:
    """A human who stands, and then stands elsewhere [m] with another heading [degrees]."""
    angle = np.radians(turn)
    rotation = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    lines = ['figure = "human"', "[[keyframe]]", "time = 0", 'others = "rest"', "[[keyframe]]", f"time = {time}"]
    lines += ['others = "previous"', 'root.position = "free"', f"root.rotation.heading = {turn}"]
    for side, y in (("left", 0.09), ("right", -0.09)):
        place = rotation @ [-0.055, y] + [forward, left]
        lines.append(f"sites.{side}_heel = [{place[0]:.4f}, {place[1]:.4f}, 0]")
        lines.append(f"bodies.{side}_foot = {{flat = true, heading = {turn}}}")
    return "\n".join(lines) + "\n" + more


def leading(text: str) -> str | None:
    """The name of the foot that steps first; None without steps."""
    loaded = recordings.from_text(text, name="steps")
    inferred = loaded.context.schedule.footsteps
    notes = [note for note in loaded.notes if "so they take" in note]
    assert len(notes) == len(inferred) <= 1
    if not inferred:
        return None
    name = loaded.figure.links[inferred[0].leading].name.removesuffix("_ankle")
    assert f"{name}_ankle first" in notes[0]
    return name


@pytest.mark.parametrize(
    ("move", "first"),
    [
        ({"forward": 0.0, "left": 0.3}, "left"),
        ({"forward": 0.0, "left": -0.3}, "right"),
        ({"forward": 0.0, "turn": 60}, "left"),
        ({"forward": 0.0, "turn": -60}, "right"),
        ({"forward": 0.4, "time": 0.7}, None),  # no time for two steps
        ({"forward": 0.9}, "left"),
        ({"forward": 0.9, "time": 1.1}, None),  # no time for three steps
        ({"forward": 0.05}, None),  # less than a step
        ({"forward": 0.0, "turn": 150, "time": 1.8}, "left"),
        ({"forward": 0.0, "turn": -150, "time": 1.8}, "right"),
        ({"forward": 0.0, "turn": 150}, None),  # no time for four steps
    ],
)
def test_the_foot_on_the_side_of_the_move_steps_first(move, first):
    assert leading(clip(**move)) == first


def test_the_foot_behind_steps_first_straight_ahead():
    for ahead in ("left", "right"):
        behind = "right" if ahead == "left" else "left"
        text = clip(0.4).replace('others = "rest"', f'others = "rest"\nroot.position = "free"\n{stride(ahead)}', 1)
        assert leading(text) == behind


def stride(ahead: str) -> str:
    """A keyframe's rows: one foot is 25 cm ahead of the other."""
    return "\n".join(
        f"sites.{side}_heel = [{-0.055 + 0.15 * (side == ahead) - 0.1 * (side != ahead)}, {y}, 0]\n"
        f"bodies.{side}_foot.flat = true"
        for side, y in (("left", 0.09), ("right", -0.09))
    )


@pytest.mark.parametrize(
    ("contacts", "first"),
    [
        ([("right_heel", 0, 0.5)], "left"),
        ([("left_heel", 0, 0.5)], "right"),
        ([("left_heel", 0, 0.5), ("right_heel", 0, 0.5)], None),
    ],
)
def test_contacts_that_the_clip_specifies_decide(contacts, first):
    rows = (f'[[contact]]\npoint = "{point}"\nfrom = {since}\nto = {until}\n' for point, since, until in contacts)
    assert leading(clip(0.4, more="".join(rows))) == first


def soles(motion: Motion, rate: float) -> Array:
    """(T, 2 feet, 2 ends, 3) [m] of heels and toes, by MuJoCo."""
    names = [f"{side}_{end}" for side in ("left", "right") for end in ("heel", "toe")]
    return tracks(motion.model, motion.sampled(rate).qpos, names).reshape(-1, 2, 2, 3)


@pytest.mark.parametrize(
    ("move", "count"),
    [
        ({"forward": 0.6, "time": 6.0}, 2),
        ({"forward": 1.3, "time": 3.0}, 3),
        ({"forward": 2.0, "time": 3.0}, 4),
        ({"forward": -1.0, "time": 3.0}, 3),
        ({"forward": 0.0, "left": 1.0, "time": 3.0}, 4),  # a foot does not overtake the other one to the side
        ({"forward": 0.0, "turn": 170, "time": 3.0}, 4),
    ],
)
def test_feet_take_as_few_steps_as_the_distance_needs(move, count):
    (steps,) = recordings.from_text(clip(**move), name="steps").context.schedule.footsteps
    assert steps.count == count
    landings = sorted({(stance.point.link, round(stance.first, 6)) for stance in steps.stances if stance.first > 0})
    assert len(landings) == count
    order = [link for link, _ in sorted(landings, key=lambda landing: landing[1])]
    assert order[0] == steps.leading
    assert all(one != other for one, other in pairwise(order))


def test_feet_do_not_step_on_a_box_in_their_way():
    box = "[[scene.box]]\nposition = [1.0, 0, 0.1]\nsize = [0.6, 2, 0.2]\n"
    loaded = recordings.from_text(clip(2.0, time=3.0, more=box), name="steps")
    assert not loaded.context.schedule.footsteps
    assert any("no gait cycle" in note for note in loaded.notes)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("move", "lift"),
    [
        ({"forward": 0.1, "time": 1.0}, 0.01),
        ({"forward": 0.4, "time": 0.8}, 0.05),
        ({"forward": 0.4, "time": 0.9}, 0.05),  # both feet floated 8 cm above the ground without the order of the steps
        ({"forward": 2.0, "time": 2.5}, 0.05),
        ({"forward": -1.0, "time": 2.0}, 0.03),
        ({"forward": 0.0, "left": 1.0, "time": 2.2}, 0.03),
        ({"forward": 0.0, "turn": 170, "time": 2.0}, 0.03),
    ],
)
def test_a_figure_steps_from_one_keyframe_to_the_next(move, lift):
    motion = inbetween(recordings.from_text(clip(**move), name="steps"))
    places = soles(motion, 200)
    low = places[..., 2].min(axis=2)
    assert low.max(axis=0).min() > lift
    assert low.min(axis=1).max() < 0.015
    speed = np.linalg.norm(np.gradient(places, 1 / 200, axis=0)[..., :2], axis=-1)
    standing = speed.max(axis=2).min(axis=1)  # of the foot that moves less
    assert np.quantile(standing, 0.95) < 0.25
    assert not [v for v in motion.violations if v.kind in ("float", "slide", "drag", "stance", "penetration")]


@pytest.mark.slow
def test_a_figure_that_stands_in_all_keyframes_walks_between_them():
    """Equal poses are no gait cycle, although they fit one in which the legs do not move."""
    stands = (clip(0.5 * k, time=1.0 * k).split("[[keyframe]]")[2] for k in range(1, 5))
    text = "[[keyframe]]".join((clip(0.0).rpartition("[[keyframe]]")[0], *stands))
    loaded = recordings.from_text(text, name="stands")
    assert [steps.segment for steps in loaded.context.schedule.footsteps] == [0, 1, 2, 3]
    assert loaded.problem.ends == "clamped"
    motion = inbetween(loaded)
    assert not [v for v in motion.violations if v.kind in ("float", "slide", "drag", "stance", "penetration")]


def test_feet_that_slide_cost_as_much_as_they_are_too_low(rng):
    """In the middle of a step of 40 cm, two points of a foot are 0.4 · 12 cm too low on the ground."""
    loaded = recordings.from_text(clip(0.4), name="steps")
    penalty = next(penalty for penalty, _ in loaded.problem.penalties if penalty.name == "attach.stance")
    path, swing = path_of(loaded.problem.raw), loaded.context.schedule.footsteps[0].swings[0]
    middle = loaded.problem.objective.samples(path, np.array([(swing.first + swing.last) / 2]))
    assert isinstance(penalty, Attachment)
    on_ground, planted = penalty.evaluate(middle), Attachment(penalty.stances).evaluate(middle)
    np.testing.assert_allclose(on_ground - planted, 2 * (0.4 * 0.12) ** 2, rtol=0.1)
    assert penalty_slope(penalty, loaded.problem.objective.samples(path, np.linspace(0.02, 1.18, 24)), rng) > 1.95


@pytest.mark.slow
def test_a_hold_of_the_legs_does_not_keep_them_from_stepping():
    """An arm that moves fast in the next segment would hold all joints that are equal before it, and the feet slid."""
    legs = "\n".join(f"bodies.{side}_foot.flat = true" for side in ("left", "right"))
    rows = [
        f'[[keyframe]]\ntime = {time}\nothers = "previous"\nroot.position = [{x}, 0, 0.9]\n{legs}\n'
        f"sites.left_heel = [{x - 0.055}, 0.09, 0]\nsites.right_heel = [{x - 0.055}, -0.09, 0]\n"
        for time, x in ((0.0, 0.0), (1.0, 0.4), (1.6, 0.4))
    ]
    rows[0] = rows[0].replace('"previous"', '"rest"')
    wave = "joints.left_shoulder = {rotvec = [90, 0, 0]}\n"
    motion = inbetween(recordings.from_text('figure = "human"\n' + "".join(rows) + wave, name="steps"))
    assert soles(motion, 100)[..., 2].min(axis=2).max(axis=0).min() > 0.05
    assert not [violation for violation in motion.violations if violation.kind in ("slide", "overshoot", "stance")]


def raised(x: float) -> str:
    """A keyframe's rows: the right heel is 10 cm up at x [m]; the left foot stands at the origin or 40 cm ahead."""
    stand = -0.055 if x < 0.2 else 0.345
    return (
        f"root.position = [{x - 0.07}, 0, 0.91]\nsites.right_heel = [{x}, -0.09, 0.1]\nbodies.right_foot.flat = true\n"
        f"sites.left_heel = [{stand}, 0.09, 0]\nbodies.left_foot.flat = true\n"
    )


@pytest.mark.slow
@pytest.mark.parametrize("seconds", [0.5, 0.9])
@pytest.mark.parametrize("is_landing", [True, False])
def test_a_raised_foot_lands_before_the_other_one_steps_and_lifts_after_it(is_landing, seconds):
    """The right foot is in the air, and after or before it both stand 40 cm apart: the feet slid by 10 to 20 cm."""
    stand = "root.position = [{0}, 0, 0.91]\n" + "".join(
        f"sites.{side}_heel = [{{1}}, {y}, 0]\nbodies.{side}_foot.flat = true\n"
        for side, y in (("left", 0.09), ("right", -0.09))
    )
    rows = [stand.format(0, -0.055), raised(0.15), stand.format(0.4, 0.345)]
    times = (0.0, 0.3, 0.3 + seconds)
    if not is_landing:
        rows, times = [rows[0], raised(0.3), rows[2]], (0.0, seconds, seconds + 0.3)
    keys = "".join(f"[[keyframe]]\ntime = {t}\nothers = 'rest'\n{row}" for t, row in zip(times, rows, strict=True))
    loaded = recordings.from_text('figure = "human"\n' + keys, name="steps")
    inferred = loaded.context.schedule.footsteps
    if seconds < 0.6:  # no time for two steps
        assert not inferred
        return
    (steps,) = inferred
    assert (steps.segment, loaded.figure.links[steps.leading].name) == (
        (1, "right_ankle") if is_landing else (0, "left_ankle")
    )
    motion = inbetween(loaded)
    assert not [violation for violation in motion.violations if violation.kind in ("float", "slide", "drag", "stance")]


def test_specified_flights_and_contacts_of_the_same_foot_replace_steps():
    flight = "[[penalty]]\nkind = 'flight'\nintervals = [[0.3, 0.7]]\n"
    contact = "[[contact]]\npoint = 'left_toe'\nfrom = 0\nto = 0.9\n"
    assert leading(clip(0.4)) is not None
    assert leading(clip(0.4, more=flight)) is None
    assert leading(clip(0.4, more=contact)) is None


def times(steps: Footsteps) -> set[tuple[float, float]]:
    """When the foot that steps first stands."""
    return {(stance.first, stance.last) for stance in steps.stances if stance.point.link == steps.leading}


def test_a_hand_with_a_target_does_not_keep_the_root_behind_the_feet():
    hand = "sites.left_hand = [1.5, 0.3, 1.2]\n"
    keys = recordings.from_text(clip(1.2, time=3.0) + hand, name="steps").context.keys
    assert keys.states[1, 0] - keys.states[0, 0] == pytest.approx(1.2, abs=0.1)
    assert keys.states[1, 2] == pytest.approx(keys.states[0, 2], abs=0.03)


def notes(keyframes: list[tuple[float, float, float]], more: str = "") -> list[str]:
    """Notes on steps for a human at rest that stands at (time [s], distance [m], height above the floor [m])."""
    text = 'figure = "human"\n' + "".join(
        f'[[keyframe]]\ntime = {t}\nroot.position = [{x}, 0, {0.93 + z}]\nothers = "rest"\n' for t, x, z in keyframes
    )
    return [note for note in recordings.from_text(text + more, name="steps").notes if "steps" in note]


def test_a_note_names_the_longest_way_that_a_figure_moves_on_both_feet():
    (note,) = notes([(0, 0, 0), (0.5, 0, 0), (1.1, -0.8, 0), (1.6, -0.8, 0)])
    assert note.startswith("keyframes 2 and 3, 0.6 s apart, form no gait cycle")
    assert "every foot moves 0.8 m;" in note
    (note,) = notes([(0, 0, 0), (0.6, 0.5, 0), (1.4, 1.3, 0)])
    assert note.startswith("keyframes 2 and 3")
    assert "0.8 m, as for 1 more pair of keyframes;" in note


@pytest.mark.parametrize(
    "keyframes",
    [
        [(0, 0, 0), (0.6, 0.2, 0)],  # less than a step
        [(0, 0, 0), (0.3, 0.5, 0)],  # no time for one
        [(0, 0, 0), (0.6, 0.5, 1.0), (1.2, 1.0, 0)],  # in the air
    ],
)
def test_figures_that_step_or_fly_have_no_note(keyframes):
    assert notes(keyframes) == []
