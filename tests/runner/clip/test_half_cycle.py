"""Half a gait cycle: its mirror image makes the other half."""

import re
from dataclasses import replace

import numpy as np
import pytest
import shipped

import dynsplines
from dynsplines import UserError, models, solving
from dynsplines.clip.load import clip_from_motion
from dynsplines.edit import files
from dynsplines.recordings import from_text
from dynsplines.studio.loop import SolverLoop
from dynsplines.system.progress import Progress

WALK = models.clip_text("walk_loop")
END = "[[keyframe]]\ntime = 0.54\n"


def half_of(walk: str) -> str:
    """The left step of a walk; the stances of the right foot follow from those of the left one."""
    head, *keys = walk.replace('ends = "periodic"', 'travel = [1.38, 0, 0]\nends = "mirrored"').split("[[keyframe]]")
    head, *contacts = head.split("[[contact]]")
    left = [f"[[contact]]{contact}" for contact in contacts if "left" in contact]
    first = [f"[[keyframe]]{key}" for key in keys if float(re.findall(r"time = (\S+)", key)[0]) < 0.54]
    return "".join([head, *left, *first, END])


HALF = half_of(WALK)
HALF_AT_REST = """figure = "human"
solve = {{ends = "mirrored", travel = [1.4, 0, 0]}}
[[keyframe]]
time = 0
joints.left_hip = {{rotvec = [0, -20, 0]}}
{0}
[[keyframe]]
time = 0.25
root.position = [0.35, 0, 0.93]
others = "rest"
[[keyframe]]
time = 0.5
"""


def test_half_a_walk_is_the_walk_also_when_it_is_saved_or_written_as_a_whole(tmp_path):
    whole = shipped.loaded("walk_loop")
    half = from_text(HALF, name="half", where="half.toml")
    assert half.ends == "periodic" and len(half.keys) == len(whole.keys)
    for one, other in zip(half.problem.raw.frames, whole.problem.raw.frames, strict=True):
        assert one.time == pytest.approx(other.time, abs=1e-12)
        np.testing.assert_allclose(one.state, other.state, atol=2e-4)  # the file's whole walk has four decimals
    stances = [
        sorted((c.point.name, round(c.first, 9), round(c.last, 9)) for c in clip.context.schedule.on_ground)
        for clip in (half, whole)
    ]
    assert stances[0] == stances[1]

    solved = half.with_problem(settings=replace(half.settings, max_evaluations=1))
    again = clip_from_motion(solving.solve(solved, Progress()))
    assert {p.name for p, _ in again.penalties} == {p.name for p, _ in half.penalties}
    assert again.context.schedule.on_ground and len(again.keys) == len(half.keys)

    source, target = tmp_path / "half.toml", tmp_path / "whole.toml"
    source.write_text(HALF)
    files.mirror(str(source), target, append=True, overwrite=False, progress=Progress())
    written = dynsplines.load(target)
    for one, other in zip(written.keys, half.keys, strict=True):
        np.testing.assert_allclose(one.state, other.state, atol=1e-9)


def test_keyframes_at_rest_travel_as_others_do():
    """Their root is then where the model has it."""
    rest = HALF_AT_REST.format("others = 'rest'")
    named = HALF_AT_REST.format("root = {position = [0, 0, 0.93], rotation = {rotvec = [0, 0, 0]}}\nothers = 'rest'")
    one, other = (from_text(text, name="half") for text in (rest, named))
    for key, expected in zip(one.keys, other.keys, strict=True):
        np.testing.assert_allclose(key.state, expected.state, atol=1e-12)
    assert one.keys[-1].state[0] == pytest.approx(1.4)


WRONG = {
    "a grasp": (END, END + "[[grasp]]\nhand = 'a'\nbody = 'b'\nfrom = 0\nto = 0.2\n", "[[grasp]] is not for half a"),
    "a turn": ("[solve]", "[solve]\nturn = 30", "a figure that turns has no mirrored half"),
    "a travel aside": ("[1.38, 0, 0]", "[1.38, 0.2, 0]", "give travel = [x, 0, z]"),
    "no travel": ("travel = [1.38, 0, 0]\n", "", "give travel = [x, 0, z]"),
    "a pose at its end": (END, END + "joints.spine = {rotvec = [0, 0, 0]}\n", "specify only its time"),
    "a contact before it": ("from = 0.00\nto = 0.41", "from = -0.10\nto = 0.41", "outside the clip, which runs"),
    "no other side": ('point = "left_heel"', 'point = "nothing"', "no site 'nothing'"),
}


@pytest.mark.parametrize("name", WRONG)
def test_what_has_no_mirror_image_is_refused(name):
    before, after, message = WRONG[name]
    assert before in HALF
    with pytest.raises(UserError) as caught:
        from_text(HALF.replace(before, after), name="half", where="half.toml")
    assert str(caught.value).startswith("half.toml: ") and message in str(caught.value), caught.value


def test_the_studio_names_the_command_that_writes_the_whole_cycle(tmp_path):
    with pytest.raises(UserError, match=r"dynsplines mirror half\.toml --append"):
        SolverLoop(print, lambda: False).do_load(HALF, "half", "half.toml", str(tmp_path), 0, go=False)
