"""The clip's [[contact]] tables: what they become, what they replace, and every mistake in one line."""

from dataclasses import replace

import numpy as np
import pytest
from rekeyed import with_keys

from dynsplines import inbetween as solve
from dynsplines import recordings
from dynsplines.clip import load as clips
from dynsplines.errors import UserError
from dynsplines.measure.report import report
from dynsplines.solver.contacts import Rest, Stance
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import Attachment, Contact, RestPenalty, Sum
from dynsplines.solver.surface.points import places_of

STEP = """
figure = "human"
[[keyframe]]
time = 0.0
others = "rest"
[[keyframe]]
time = 0.5
root.position = [{x}, 0, 0.93]
others = "rest"
[[keyframe]]
time = 1.0
root.position = [{y}, 0, 0.93]
others = "rest"
"""


def text(*contacts: str, x: float = 0.0, y: float = 0.0) -> str:
    return STEP.format(x=x, y=y) + "".join(f"[[contact]]\n{contact}\n" for contact in contacts)


def planted(clip: clips.Clip) -> tuple[tuple[Stance, ...], tuple[Rest, ...]]:
    penalties = [penalty for penalty, _ in clip.penalties if penalty.name in ("attach.stance", "attach.contact")]
    parts = [p for penalty in penalties for p in (penalty.parts if isinstance(penalty, Sum) else (penalty,))]
    stances = tuple(stance for part in parts if isinstance(part, Attachment) for stance in part.stances)
    return stances, tuple(rest for part in parts if isinstance(part, RestPenalty) for rest in part.rests)


def test_without_a_table_keyframes_tell_where_feet_stand():
    stances, rests = planted(recordings.from_text(text(), name="stand"))
    assert {(s.point.name, s.first, s.last) for s in stances} >= {("left_heel", 0.0, 0.5), ("right_toe", 0.5, 1.0)}
    assert not rests


def test_a_contact_takes_its_spot_from_the_keyframes_inside_and_holds_it_beyond():
    contact = 'point = "left_heel"\nfrom = 0.25\nto = 0.8'
    stances, rests = planted(recordings.from_text(text(contact), name="stand"))
    own = sorted((s for s in stances if s.point.name == "left_heel"), key=lambda s: s.first)
    assert [(s.first, s.last) for s in own] == [(0.25, 0.5), (0.5, 0.8)]
    np.testing.assert_allclose([s.spot for s in own], [own[0].landed] * 2)
    assert not rests
    assert any(s.point.name == "left_toe" and s.first == 0 for s in stances)


def test_a_contact_that_a_keyframe_begins_in_the_floor_rises_with_what_is_let_pass():
    sunk = text('point = "left_heel"\nfrom = 0.3\nto = 0.8').replace("[0.0, 0, 0.93]", "[0.0, 0, 0.90]", 1)
    clip = recordings.from_text(sunk, name="sunk")
    stances, _ = planted(clip)
    before, after = sorted(
        (s for s in stances if s.point.name == "left_heel" and s.first >= 0.3), key=lambda s: s.first
    )
    (clearance,) = [p for p, _ in clip.penalties if p.name == "collision.soles" and isinstance(p, Contact)]
    assert clearance.allowed is not None
    heel = [point.name for point in clearance.points].index("left_heel")
    for end, spot in ((0.3, before.spot), (0.5, before.landed), (0.5, after.spot), (0.8, after.landed)):
        let_pass = clearance.allowed.at(np.array([end]))[heel, 0]
        depth = -(spot[2] - clearance.points[heel].radius)
        assert depth == pytest.approx(let_pass, abs=1e-9)
        assert depth > 0.005
    np.testing.assert_allclose(before.spot[:2], before.landed[:2])


@pytest.mark.slow
def test_other_keyframes_are_posed_anew():
    squat = """
figure = "human"
keyframe = [{time = 0, others = "rest"}, {time = 1, root.position = [0, 0, 0.7]}, {time = 2, others = "rest"}]
"""
    clip = recordings.from_text(squat, name="squat")
    higher = recordings.from_text(squat.replace("0.7]", "0.8]"), name="squat")
    moved = np.array(clip.keys[1].state)
    moved[2] = 0.8
    again = with_keys(clip, [clip.keys[0], replace(clip.keys[1], state=moved), clip.keys[2]])
    still = np.zeros((2, 1, clip.figure.width))
    feet = [Samples(clip.figure, clip.figure.to_state(k.keys[1].state[None]), *still) for k in (higher, again)]
    assert again.keys[1].posed is not None
    np.testing.assert_array_equal(again.keys[1].posed, higher.keys[1].posed)
    np.testing.assert_allclose(feet[0].links.x, feet[1].links.x, atol=2e-3)


def test_a_contact_with_a_position_and_one_that_nobody_placed():
    contacts = (
        'point = "left_heel"\nfrom = 0.6\nto = 0.9\nposition = [0.3, 0.1, 0]',
        'point = "right_toe"\nfrom = 0.6\nto = 0.9',
    )
    stances, rests = planted(recordings.from_text(text(*contacts, x=0.2, y=0.4), name="walk"))
    (own,) = [s for s in stances if s.point.name == "left_heel"]
    np.testing.assert_allclose(own.place(np.array([0.6, 0.75, 0.9])), np.array([[0.3, 0.1, 0]] * 3).T)
    assert [(r.point.name, r.first, r.last) for r in rests] == [("right_toe", 0.6, 0.9)]


@pytest.mark.slow
def test_a_foot_rests_where_a_contact_says_without_it_does_not_and_the_report_tells_how_far():
    contact = 'point = "left_toe"\nfrom = 0.55\nto = 0.75'
    no_slip = '[[penalty]]\nkind = "no_slip"\nweight = 0'
    moved = []
    clips = [recordings.from_text(text(*one, x=0.2, y=0.4) + no_slip, name="it") for one in ((), (contact,))]
    motions = [inbetween(clip.problem) for clip in clips]
    for clip, motion in zip(clips, motions, strict=True):
        y, y_d, y_dd = path_of(motion.timeline).motion(t := np.linspace(0.55, 0.75, 101))
        toe = tuple(point for point in clip.context.points if point.name == "left_toe")
        centres, _ = places_of(toe, Samples(clip.figure, y, y_d, y_dd, t))
        moved.append(float(np.ptp(centres[0, 0])))
    assert moved[0] > 0.05
    assert moved[1] < 0.005
    told = report(clips[1], motions[1], 0.0)
    (before,), (after,) = told["before"]["contacts"], told["after"]["contacts"]
    assert (after["point"], after["from, s"], after["to, s"]) == ("left_toe", 0.55, 0.75)
    assert before["moved, m"] > 0.03
    assert after["moved, m"] < 0.005
    assert after["path, m"] >= after["moved, m"]
    assert after["speed, m/s"] == pytest.approx(after["path, m"] / 0.2)


@pytest.mark.parametrize(
    ("contacts", "words"),
    [
        (('point = "left_hee"\nfrom = 0\nto = 1',), ["contact 1 ('left_hee')", "left_heel"]),
        (('point = "left_heel"\nfrom = 0.8\nto = 0.3',), ["contact 1 ('left_heel')", "0.8", "not before", "0.3"]),
        (('point = "left_heel"\nfrom = 0.5\nto = 1.5',), ["outside the clip", "from 0 to 1 s"]),
        (
            ('point = "left_heel"\nfrom = 0\nto = 0.6', 'point = "left_heel"\nfrom = 0.4\nto = 1'),
            ["contact 2 ('left_heel')", "overlaps contact 1", "0.4 to 0.6"],
        ),
        (
            ('point = "left_heel"\nfrom = 0.2\nto = 0.8\nposition = [0.4, 0.1, 0]',),
            ["contact 1 ('left_heel')", "keyframe 2 (t = 0.5 s)", "the contact's position"],
        ),
        (
            (
                'point = "left_heel"\nfrom = 0.6\nto = 0.8\nposition = [0, 0.1, 0]',
                'point = "left_toe"\nfrom = 0.7\nto = 0.9\nposition = [0.5, 0.1, 0]',
            ),
            ["'left_heel' and 'left_toe' contradict each other", "0.7 to 0.8", "0.500 m apart"],
        ),
        (('point = "left_heel"\nfrom = "soon"\nto = 1',), ["contact 1", "from must be a number"]),
        (('point = "left_heel"\nto = 1',), ["contact 1", "'from' is missing"]),
    ],
)
def test_mistakes_are_told_in_one_line(contacts, words):
    with pytest.raises(UserError) as told:
        recordings.from_text(text(*contacts), name="wrong")
    assert "\n" not in str(told.value)
    for word in words:
        assert word in str(told.value)


@pytest.mark.parametrize(
    ("more", "x", "words"),
    [
        ("", 0.02, r"keyframe 3 .* 0\.400 m from where keyframe 1 does"),
        ("\nposition = [5, 0, 0]", 0.0, r"puts the point [0-9.]+ m from the contact's position; a contact may drift"),
    ],
)
def test_a_contact_far_from_its_keyframes_is_reported(more, x, words):
    with pytest.raises(UserError, match=words):
        recordings.from_text(text(f'point = "left_heel"\nfrom = 0\nto = 1{more}', x=x, y=20 * x), name="far")


@pytest.mark.slow
def test_legs_do_not_whip_where_keyframes_put_a_foot_into_a_step():
    standing = "".join(f'[[keyframe]]\ntime = {t}\nothers = "rest"\n' for t in (0.0, 0.5, 1.0))
    head = 'figure = "human"\n[solve]\nends = "free"\n'
    inside = recordings.from_text(f"{head}[scene]\nstep = {{x = 0.0, height = 0.3}}\n{standing}", name="inside")
    motion = inbetween(inside.problem)
    qpos = motion.at(np.linspace(0, 1, 100))
    np.testing.assert_allclose(qpos, np.broadcast_to(qpos[0], qpos.shape), atol=0.02)


@pytest.mark.parametrize("off", [0.0, 0.02, 0.045])
def test_the_distance_from_a_specified_position_is_reported_if_keyframes_put_the_point_elsewhere(off):
    loaded = recordings.from_text(text(), name="stand")
    heel = next(point for point in loaded.context.points if point.name == "left_heel")
    x, y, z = places_of([heel], Samples.still(loaded.figure, loaded.context.keys.states))[0][:, 0, 0]
    contact = f'point = "left_heel"\nfrom = 0\nto = 1\nposition = [{x + off}, {y}, {z}]'
    solved = solve(recordings.from_text(text(contact), name="stand"))
    rows = [violation for violation in solved.violations if violation.kind == "contact"]
    assert bool(rows) == (off > 0.01)
    assert all(violation.amount == pytest.approx(off, abs=1e-6) for violation in rows)
