"""The ends of a clip: at rest where its first and last keyframes are poses at rest, unless its text says otherwise."""

import numpy as np
import pytest

from dynsplines import recordings
from dynsplines.clip import load
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.inbetween import inbetween

HEAD = 'figure = "human"\n[solve]\nevaluations = 3\nframes = 2\n'
STAND = '[[keyframe]]\ntime = {}\nothers = "rest"\n{}'
RAISED = "joints.left_shoulder = {rotvec = [0, -120, 0]}\n"
ALOFT = "root.position = [0, 0, 1.3]\n"


def clip(first: str, middle: str, last: str, head: str = HEAD) -> load.Clip:
    bodies = enumerate((first, middle, last))
    return recordings.from_text(head + "".join(STAND.format(0.4 * i, body) for i, body in bodies), name="c")


def end_speeds(found: load.Clip) -> np.ndarray:
    path = path_of(inbetween(found.problem).timeline)
    return np.abs(path.at(np.array(path.span), 1)).max(axis=1)


@pytest.mark.parametrize(("ends", "at_rest"), [("free", [0, 0]), ("clamped", [1, 1]), ("clamped start", [1, 0])])
def test_the_text_decides(ends, at_rest):
    found = clip("", RAISED, "", f'{HEAD}ends = "{ends}"\n')
    assert found.ends == ends
    assert not any("ends =" in note for note in found.notes)
    assert (end_speeds(found) < 1e-9).tolist() == at_rest


@pytest.mark.parametrize(
    ("bodies", "ends"),
    [
        (("", RAISED, ""), "clamped"),
        ((ALOFT, "", ""), "clamped end"),
        (("", "", ALOFT), "clamped start"),
        (("root.position = [-0.5, 0, 0.9]\n", RAISED, RAISED), "clamped end"),
        ((ALOFT, ALOFT, ALOFT), "clamped"),  # each repeats its neighbour
        ((ALOFT + RAISED, ALOFT, ALOFT), "clamped end"),
        ((ALOFT + RAISED, ALOFT, "root.position = [0, 0, 1.4]\n"), "free"),
    ],
)
def test_ends_are_at_rest_and_noted_unless_they_move_or_are_in_the_air(bodies, ends):
    found = clip(*bodies)
    assert found.ends == ends
    at_rest = end_speeds(found) < 1e-9
    assert at_rest.tolist() == [ends in ("clamped", "clamped start"), ends in ("clamped", "clamped end")]
    assert any("ends = 'free'" in note for note in found.notes) == at_rest.any()


@pytest.mark.parametrize(
    ("base", "box", "ends"),
    [("", "", "clamped"), ("", '<freejoint name="box"/>', "clamped"), ("<freejoint/>", "", "free")],
)
def test_an_arm_on_a_fixed_base_begins_and_ends_at_rest(tmp_path, base, box, ends):
    (tmp_path / "arm.xml").write_text(
        f"""<mujoco><option gravity="0 0 0"/><worldbody>
          <body>{base}<geom size=".1"/>
            <body><joint name="lift" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0 0 .4" size=".04"/>
              <body pos="0 0 .4"><joint name="elbow" axis="0 1 0"/><geom size=".04"/></body></body></body>
          <body pos="1 0 0">{box}<geom size=".1"/></body></worldbody></mujoco>"""
    )
    keyframes = "".join(
        f'[[keyframe]]\ntime = {0.4 * i}\nothers = "rest"\njoints.lift = {20 * i * i}\njoints.elbow = {30 * i}\n'
        for i in range(3)
    )
    head = f'figure = "{tmp_path / "arm.xml"}"\n[solve]\nframes = 2\n'
    found = recordings.from_text(head + keyframes, name="c")
    assert found.ends == ends
    assert (end_speeds(found) < 1e-9).all() == (ends == "clamped")
