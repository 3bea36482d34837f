"""The ends of a clip: at rest where its first and last keyframes are poses at rest, unless its text says otherwise."""

import numpy as np
import pytest

from dynsplines.clip import load
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.inbetween import inbetween

HEAD = 'figure = "human"\n'
STAND = '[[keyframe]]\ntime = {}\nothers = "rest"\n{}'
RAISED = "joints.left_shoulder = {rotvec = [0, -120, 0]}\n"
ALOFT = "root.position = [0, 0, 1.3]\n"


def clip(first: str, middle: str, last: str, head: str = HEAD) -> load.Clip:
    bodies = enumerate((first, middle, last))
    return load.from_text(head + "".join(STAND.format(0.4 * i, body) for i, body in bodies), name="c")


def end_speeds(found: load.Clip) -> np.ndarray:
    path = path_of(inbetween(found.problem).timeline)
    return np.abs(path.at(np.array(path.span), 1)).max(axis=1)


def test_a_clip_between_standing_poses_begins_and_ends_at_rest_and_says_so():
    found = clip("", RAISED, "")
    assert found.ends == "clamped"
    assert any("ends = 'free'" in note for note in found.notes)
    assert end_speeds(found).max() < 1e-9


def test_a_pose_that_repeats_its_neighbour_is_at_rest_in_the_air_too():
    assert clip(ALOFT, ALOFT, ALOFT).ends == "clamped"
    assert clip(ALOFT + RAISED, ALOFT, ALOFT).ends == "clamped end"


@pytest.mark.parametrize("ends", ["free", "clamped"])
def test_the_text_decides(ends):
    found = clip("", RAISED, "", f'{HEAD}[solve]\nends = "{ends}"\n')
    assert found.ends == ends
    assert not any("ends =" in note for note in found.notes)
    assert (end_speeds(found).max() < 1e-9) == (ends == "clamped")


@pytest.mark.parametrize(
    ("bodies", "ends"),
    [
        ((ALOFT, "", ""), "clamped end"),
        (("", "", ALOFT), "clamped start"),
        (("root.position = [-0.5, 0, 0.9]\n", RAISED, RAISED), "clamped end"),
        ((ALOFT + RAISED, ALOFT, "root.position = [0, 0, 1.4]\n"), "free"),
    ],
)
def test_an_end_that_moves_or_is_in_the_air_is_free(bodies, ends):
    found = clip(*bodies)
    assert found.ends == ends
    at_rest = end_speeds(found) < 1e-9
    assert at_rest.tolist() == [ends == "clamped start", ends == "clamped end"]
    assert any("ends = 'free'" in note for note in found.notes) == at_rest.any()


def test_the_text_may_set_one_end():
    found = clip(ALOFT + RAISED, ALOFT, "root.position = [0, 0, 1.4]\n", f'{HEAD}[solve]\nends = "clamped start"\n')
    assert (end_speeds(found) < 1e-9).tolist() == [True, False]
