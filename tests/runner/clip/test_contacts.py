"""Contacts and grasps of a clip."""

import mujoco
import numpy as np
import pytest
from motions import raw_violations
from oracles import kinematics
from shipped import in_carried
from texts import read_data

import dynsplines
from dynsplines import Keyframe, Motion, recordings
from dynsplines.clip import load as clips
from dynsplines.clip.mirror import mirrored_tables
from dynsplines.clip.parse import table_of
from dynsplines.clip.text import text_of
from dynsplines.errors import UserError
from dynsplines.measure.report import report
from dynsplines.measure.violation import violations
from dynsplines.solver import quaternion as quat
from dynsplines.solver.contacts import Contact
from dynsplines.solver.curve.mirror import Mirror
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import Attachment, Collision, Sum
from dynsplines.solver.surface.points import places_of
from dynsplines.solving import motion_of

STEP = read_data("planted.toml")


def text(*contacts: str, x: float = 0.0, y: float = 0.0) -> str:
    return STEP.format(x=x, y=y) + "".join(f"[[contact]]\n{contact}\n" for contact in contacts)


def planted(clip: clips.Clip) -> tuple[list[Contact], list[Contact]]:
    """The contacts at known positions, and the others."""
    found = [contact for name in ("attach.stance", "attach.contact") for contact in contacts_in(clip, name)]
    return [c for c in found if c.is_placed], [c for c in found if not c.is_placed]


def contacts_in(clip: clips.Clip, name: str) -> list[Contact]:
    return [c for part in parts(clip, name) if isinstance(part, Attachment) for c in part.contacts]


def test_a_contact_takes_its_spot_from_the_keyframes_inside_and_holds_it_beyond():
    contact = 'point = "left_heel"\nfrom = 0.25\nto = 0.8'
    stances, rests = planted(recordings.from_text(text(contact), name="stand"))
    (own,) = (s for s in stances if s.point.name == "left_heel")
    assert (own.first, own.last) == (0.25, 0.8)
    places = own.place(np.array([0.25, 0.5, 0.8])).T
    np.testing.assert_allclose(places, [places[1]] * 3)
    assert not rests
    assert any(s.point.name == "left_toe" and s.first == 0 for s in stances)


def test_a_contact_that_a_keyframe_begins_in_the_floor_rises_with_what_is_let_pass():
    sunk = text('point = "left_heel"\nfrom = 0.3\nto = 0.8').replace("[0.0, 0, 0.93]", "[0.0, 0, 0.90]", 1)
    clip = recordings.from_text(sunk, name="sunk")
    stances, _ = planted(clip)
    (own,) = (s for s in stances if s.point.name == "left_heel" and s.first >= 0.3)
    (clearance,) = [p for p, _ in clip.penalties if p.name == "collision.soles" and isinstance(p, Collision)]
    assert clearance.allowed is not None
    heel = [point.name for point in clearance.points].index("left_heel")
    ends = np.array([0.3, 0.5, 0.8])
    for end, spot in zip(ends, own.place(ends).T, strict=True):
        let_pass = clearance.allowed.at(np.array([end]))[heel, 0]
        depth = -(spot[2] - clearance.points[heel].radius)
        assert depth == pytest.approx(let_pass, abs=1e-9)
        assert depth > 0.005
    np.testing.assert_allclose(np.ptp(own.place(ends)[:2], axis=1), 0, atol=1e-12)


def test_a_contact_with_a_position_and_one_that_nobody_placed():
    contacts = (
        'point = "left_heel"\nfrom = 0.6\nto = 0.9\nposition = [0.3, 0.1, 0]',
        'point = "right_toe"\nfrom = 0.6\nto = 0.9',
    )
    stances, rests = planted(recordings.from_text(text(*contacts, x=0.2, y=0.4), name="walk"))
    (own,) = [s for s in stances if s.point.name == "left_heel"]
    np.testing.assert_allclose(own.place(np.array([0.6, 0.75, 0.9])), np.array([[0.3, 0.1, 0]] * 3).T)
    assert [(r.point.name, r.first, r.last) for r in rests] == [("right_toe", 0.6, 0.9)]


@pytest.mark.parametrize(("point", "reach"), [("left_heel", 0.05), ("left_hand", 0.15)])
def test_a_note_names_a_contact_at_a_position_in_the_air(point, reach):
    for height, count in ((reach - 0.001, 0), (reach + 0.001, 1)):
        contact = f'point = "{point}"\nfrom = 0.6\nto = 0.9\nposition = [0.3, 0.1, {height}]'
        clip = recordings.from_text(text(contact, x=0.2, y=0.4), name="air")
        notes = [note for note in clip.notes if f"contact of '{point}' from 0.6 to 0.9 s: no static geom" in note]
        assert len(notes) == count


@pytest.mark.slow
def test_a_foot_rests_where_a_contact_says_without_it_does_not_and_the_report_tells_how_far():
    contact = 'point = "left_toe"\nfrom = 0.55\nto = 0.75'
    no_slip = '[solve]\nevaluations = 15\n[[penalty]]\nkind = "no_slip"\nweight = 0'
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
    told = report(clips[1], motion_of(clips[1], motions[1]))
    before, after = (told[side]["largest"]["contact"] for side in ("before", "after"))
    assert before["name"] == "left_toe" and 0.55 <= before["at, s"] <= 0.75
    assert before["amount"] > 0.03
    assert after["amount"] < 0.005


@pytest.mark.parametrize(
    ("more", "x", "words"),
    [
        ("", 0.02, r"keyframe 3 .* 0\.400 m from where keyframe 1 has it"),
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


@pytest.mark.parametrize("off", [0.0, 0.02])
def test_the_distance_from_a_specified_position_is_reported_if_keyframes_put_the_point_elsewhere(off):
    loaded = recordings.from_text(text(), name="stand")
    heel = next(point for point in loaded.context.points if point.name == "left_heel")
    x, y, z = places_of([heel], Samples.still(loaded.figure, loaded.context.keys.states))[0][:, 0, 0]
    contact = f'point = "left_heel"\nfrom = 0\nto = 1\nposition = [{x + off}, {y}, {z}]'
    at_rest = raw_violations(recordings.from_text(text(contact), name="stand"))
    rows = [violation for violation in at_rest if violation.kind == "contact"]
    assert bool(rows) == (off > 0.01)
    assert all(violation.amount == pytest.approx(off, abs=1e-6) for violation in rows)


SCENE = read_data("crate.toml")


HOLD = """
[[grasp]]
hand = "{hand}_hand"
body = "crate"
from = {start}
to = {end}
"""


CRATE = "roots.crate = {{position = [{x}, 0, {z}], rotation = {{rotvec = [0, {pitch}, 0]}}}}"


AT = CRATE.format(x=0.42, z=1.0, pitch=0)


def keyframe(time: float, *lines: str) -> str:
    return "\n".join(["[[keyframe]]", f"time = {time}", *lines, ""])


STANDING = "root.position = [0, 0, 0.93]\nroot.rotation = {rotvec = [0, 0, 0]}"


HANDS = "sites.left_hand = [0.42, 0.17, 1.0]\nsites.right_hand = [0.42, -0.17, 1.0]"


def lift(*more: str, hands: tuple[str, ...] = ("left", "right")) -> str:
    """Hands at a crate in the air, which is then moved to three places without a word about the arms."""
    rows = [
        keyframe(0.0, 'others = "rest"', AT),
        keyframe(0.6, STANDING, AT, HANDS),
        keyframe(1.0, STANDING, CRATE.format(x=0.36, z=1.2, pitch=15)),
        keyframe(1.5, STANDING, CRATE.format(x=0.44, z=1.1, pitch=-10)),
        keyframe(2.1, STANDING),
    ]
    return SCENE + "".join(HOLD.format(hand=hand, start=0.6, end=1.5) for hand in hands) + "".join([*rows, *more])


@pytest.mark.slow
def test_a_crate_that_nothing_holds_in_the_air_floats():
    result = raw_violations(recordings.from_text(lift(keyframe(2.7, STANDING, AT)), name="lift"))
    floating = [violation for violation in result if violation.kind == "float"]
    assert {violation.name for violation in floating} == {"crate"}
    times = np.array([violation.time for violation in floating])
    assert np.all((times < 0.6) | (times > 1.5)) and times.min() < 0.6 and times.max() > 1.5


def place(clip: clips.Clip, qpos: np.ndarray, hand: str, held: str = "crate") -> np.ndarray:
    """(3,) where a hand is on a body, by MuJoCo."""
    data = kinematics(clip.figure.model, qpos)
    body = data.body(held)
    return body.xmat.reshape(3, 3).T @ (data.site(hand).xpos - body.xpos)


def spot_of(grasp: Contact, *times: float) -> np.ndarray:
    """(T, 3) where it is on the body."""
    return grasp.place(np.array(times)).T


def name_of(clip: clips.Clip, grasp: Contact) -> str:
    return f"{grasp.point.name} on {clip.figure.body_name(grasp.on)}"


def parts(clip: clips.Clip, name: str) -> list:
    found = [penalty for penalty, _ in clip.penalties if penalty.name == name]
    return [part for penalty in found for part in (penalty.parts if isinstance(penalty, Sum) else (penalty,))]


@pytest.fixture(scope="module")
def lifted() -> clips.Clip:
    return recordings.from_text(lift(), name="lift")


def test_boxes_that_name_a_body_are_parts_of_one_that_moves_freely(lifted):
    model = lifted.figure.model
    crate = model.body("crate")
    assert crate.mass == pytest.approx(5) and crate.jntnum == 1 and crate.geomnum == 2
    assert model.joint("crate").type == mujoco.mjtJoint.mjJNT_FREE
    assert "crate's walls" not in {surface.name for surface in lifted.context.surfaces}


def test_a_grasp_is_where_the_keyframes_have_the_site_on_the_body_and_arms_left_free_begin_there(lifted):
    grasps = lifted.context.schedule.grasps
    assert [name_of(lifted, grasp) for grasp in grasps] == ["left_hand on crate", "right_hand on crate"]
    arm = lifted.figure.model.joint("left_shoulder").qposadr[0]
    for grasp, y in zip(grasps, (0.17, -0.17), strict=True):
        assert (grasp.first, grasp.last, lifted.figure.links[grasp.on].name) == (0.6, 1.5, "crate")
        np.testing.assert_allclose(spot_of(grasp, 0.6, 0.8, 1.0, 1.5), [[0, y, 0]] * 4, atol=1e-5)
        for key in lifted.keys[2:4]:
            np.testing.assert_allclose(place(lifted, key.state, grasp.point.name), [0, y, 0], atol=1e-5)
            assert not key.fixed[arm : arm + 4].any() and key.known[arm : arm + 4].all()
    (holding,) = parts(lifted, "attach.grasp")
    assert isinstance(holding, Attachment) and [w for p, w in lifted.penalties if p is holding] == [750]


def test_a_grasp_gives_way_where_a_keyframe_puts_the_body_out_of_reach(lifted):
    told: dict[str, tuple[float, np.ndarray]] = {}
    far = recordings.from_text(lift(hands=("left",)).replace("[0.36, 0, 1.2]", "[0.98, 0, 1.2]"), name="far")
    for name, clip in {"near": lifted, "far": far}.items():
        key, grasp = clip.keys[2], next(each for each in clip.context.schedule.grasps if each.point.name == "left_hand")
        arm = clip.figure.model.joint("left_shoulder").qposadr[0]
        assert key.known[arm : arm + 4].all() and not key.fixed[arm : arm + 4].any()
        short = np.linalg.norm(place(clip, key.state, "left_hand") - [0, 0.17, 0])
        np.testing.assert_allclose(spot_of(grasp, 1.0)[0], place(clip, key.state, "left_hand"), atol=1e-6)
        np.testing.assert_allclose(spot_of(grasp, 0.6)[0], [0, 0.17, 0], atol=1e-6)
        slack = next(piece.slack for piece in grasp.pieces() if piece.first < 0.8 < piece.last)
        told[name] = float(short), np.zeros(2) if slack is None else slack
    assert told["near"][0] < 1e-5 and not told["near"][1].any()
    assert 0.02 < told["far"][0] < 0.15
    np.testing.assert_allclose(told["far"][1], np.array([0, 1.0]) * told["far"][0], atol=1e-6)


def test_a_thing_lies_where_it_was_put_until_it_is_held_and_again_after(lifted):
    own = slice(lifted.figure.model.joint("crate").qposadr[0], None)
    assert all(key.fixed[own].all() for key in lifted.keys)
    np.testing.assert_array_equal(lifted.keys[4].state[own], lifted.keys[3].state[own])
    stances = contacts_in(lifted, "attach.stance")
    assert {(s.first, s.last) for s in stances if s.point.name == "crate"} == {(0.0, 0.6), (1.5, 2.1)}
    late = recordings.from_text(lift().replace(AT, "", 1), name="late")
    np.testing.assert_array_equal(late.keys[0].state[own], lifted.keys[0].state[own])
    assert late.keys[0].fixed[own].all()
    free = lift().replace(CRATE.format(x=0.36, z=1.2, pitch=15), 'others = "previous"')
    assert not recordings.from_text(free, name="free").keys[2].fixed[own].any()


def test_a_thing_lies_still_in_the_part_of_a_segment_before_and_after_its_hold():
    """The hold begins and ends between keyframes."""

    def stances(text: str) -> set[tuple[float, float]]:
        clip = recordings.from_text(text, name="lift")
        crate = [s for s in contacts_in(clip, "attach.stance") if s.point.name == "crate"]
        ends = (s.place(np.array([s.first, s.last])) for s in crate if s.first in (0.6, 1.4))
        assert all(np.array_equal(*place.T) for place in ends)
        return {(s.first, s.last) for s in crate}

    late = lift().replace("from = 0.6", "from = 0.7").replace("to = 1.5", "to = 1.4")
    assert stances(late) == {(0.0, 0.6), (0.6, 0.7), (1.4, 1.5), (1.5, 2.1)}
    thrown = keyframe(2.1, STANDING, CRATE.format(x=0.9, z=1.0, pitch=0))
    assert stances(late.replace(keyframe(2.1, STANDING), thrown)) == {(0.0, 0.6), (0.6, 0.7)}
    caught = late.replace(keyframe(0.6, STANDING, AT, HANDS), "").replace("[0.42, 0, 1.0]", "[3, 0, 1.5]")
    assert (0.0, 0.7) not in stances(caught)


def test_a_note_names_a_thing_that_nothing_holds_or_places_after_a_hold(lifted):
    assert not [note for note in lifted.notes if "crate" in note]
    dropped = lift().replace(CRATE.format(x=0.44, z=1.1, pitch=-10), "")
    (note,) = [note for note in recordings.from_text(dropped, name="dropped").notes if "crate" in note]
    assert note.startswith("keyframe 5 does not place 'crate', which nothing holds after 1.5 s")
    placed = dropped.replace(keyframe(2.1, STANDING), keyframe(2.1, STANDING, AT))
    assert not [note for note in recordings.from_text(placed, name="placed").notes if "crate" in note]


@pytest.mark.slow
def test_a_crate_that_keyframes_leave_free_goes_with_the_hands():
    up = HANDS.replace("1.0]", "1.2]")
    rows = keyframe(0.6, STANDING, AT, HANDS), keyframe(1.0, STANDING, up), keyframe(1.4, STANDING, up)
    grasps = "".join(HOLD.format(hand=hand, start=0.6, end=1.4) for hand in ("left", "right"))
    clip = recordings.from_text(SCENE + grasps + keyframe(0.0, 'others = "rest"', AT) + "".join(rows), name="hands")
    for hand, y in (("left_hand", 0.17), ("right_hand", -0.17)):
        np.testing.assert_allclose(place(clip, clip.keys[2].state, hand), [0, y, 0], atol=1e-5)


@pytest.mark.parametrize("is_placed", [True, False])
def test_keyframes_that_fix_two_hands_farther_apart_than_they_hold_one_object_are_an_error(is_placed):
    def rows(spread: float) -> str:
        arms = "joints = {left_shoulder = {rotvec = [%g, 0, 0]}, right_shoulder = {rotvec = [%g, 0, 0]}}"
        held = keyframe(0.0, 'others = "rest"', AT if is_placed else "", arms % (20, -20))
        grasps = "".join(HOLD.format(hand=hand, start=0.0, end=1.0) for hand in ("left", "right"))
        free = 'roots.crate = {position = ["free", "free", "free"], rotation = "free"}'
        return SCENE + grasps + held + keyframe(1.0, 'others = "rest"', free, arms % (20 + spread, -20 - spread))

    recordings.from_text(rows(2), name="near")
    with pytest.raises(UserError, match=r"keyframe 2 .* m apart, but they grasp 'crate' 0\.\d+ m"):
        recordings.from_text(rows(4), name="far")


ARM = read_data("arm_and_block.xml")


def with_block(**rotation: str) -> Motion:
    """The arm swings while it holds the block, which is placed at the start of the hold alone."""
    at_hand = {"position": [0.6, 0, 1], "rotation": {"heading": 0}}
    poses = {0.0: (0, 0), 0.6: (70, 40), 1.0: (90, 80)}
    keys = [
        Keyframe(time, joints={"shoulder": shoulder, "elbow": elbow}, roots={} if time else {"block": at_hand})
        for time, (shoulder, elbow) in poses.items()
    ]
    grasp = {"hand": "hand", "body": "block", "from": 0.0, "to": 1.0, **rotation}
    return dynsplines.inbetween(dynsplines.build(ARM, keys, grasps=[grasp], solve={"evaluations": 20}))


@pytest.fixture(scope="module")
def carrying() -> Motion:
    return with_block()


def test_a_block_in_one_hand_turns_with_it_unless_its_rotation_is_free(carrying):
    for motion, is_rigid in ((carrying, True), (with_block(rotation="free"), False)):
        turns = []
        for qpos in motion.at(np.linspace(0, 1, 20)):
            data = kinematics(motion.model, qpos)
            hand, block = (data.body(name).xmat.reshape(3, 3) for name in ("fore", "block"))
            turns.append(quat.from_matrix(hand.T @ block))
        largest = np.degrees(max(quat.angle_between(turns[0], each) for each in turns))
        assert largest < 3 if is_rigid else largest > 30
        assert "grasp rotation" not in {each.kind for each in motion.violations}


def test_a_saved_motion_holds_the_body_at_the_same_places(carrying, tmp_path):
    carrying.save(tmp_path / "carrying.npz")
    loaded = dynsplines.load_motion(tmp_path / "carrying.npz")
    (saved,), (grasp,) = (motion.clip.context.schedule.grasps for motion in (loaded, carrying))
    np.testing.assert_allclose(spot_of(saved, 0.0, 0.6, 1.0), spot_of(grasp, 0.0, 0.6, 1.0), atol=1e-9)
    terms = [one.report()["after"]["terms"]["attach.grasp"] for one in (carrying, loaded)]
    assert terms[0] == pytest.approx(terms[1], rel=1e-6)


def test_a_hand_stays_within_millimetres_where_the_raw_spline_loses_the_block_and_the_report_says_so(carrying):
    clip, saved, reported = carrying.clip, carrying.saved, carrying.report()
    for motion, side, is_raw in ((saved, "after", False), (saved.before, "before", True)):
        row = reported[side]["largest"]["grasp"]
        assert (row["name"], row["unit"]) == ("hand", "m")
        states = clip.figure.to_qpos(motion.path.at(np.linspace(0.0, 1.0, 200)))
        track = np.array([place(clip, qpos, "hand", "block") for qpos in states])
        moved = np.linalg.norm(track - track[0], axis=1).max()
        assert row["amount"] == pytest.approx(moved, abs=3e-4)
        assert moved > 0.006 if is_raw else moved <= 0.003
        lost = {each.name for each in violations(clip, motion) if each.kind == "grasp"}
        assert bool(lost) == is_raw
    time = np.linspace(0.0, 1.0, 60)
    found = in_carried(clip, time, carrying.at(time))
    depth = reported["after"]["largest"].get("penetration", {"amount": 0.0})["amount"]
    assert depth == pytest.approx(found["deepest"], abs=0.003)


@pytest.mark.slow
def test_limbs_stay_out_of_what_is_carried_and_not_of_what_is_not_held():
    for hands, expected in (((), 0), (("left",), 1)):
        found = parts(recordings.from_text(lift(hands=hands), name="lift"), "collision.body")
        assert sum(isinstance(part, Collision) and part.carrier > 0 for part in found) == expected


def test_a_grasp_with_a_position_and_one_that_was_not_placed():
    free = lift(hands=()).replace(HANDS, "")
    grasp = HOLD.format(hand="left", start=0.7, end=0.9)
    (unknown,) = recordings.from_text(free + grasp, name="free").context.schedule.grasps
    assert not unknown.is_placed
    (known,) = recordings.from_text(free + grasp + "position = [0, 0.15, 0.05]\n", name="free").context.schedule.grasps
    np.testing.assert_allclose(spot_of(known, 0.7, 0.8, 0.9), [[0, 0.15, 0.05]] * 3)


def test_a_mirrored_clip_holds_with_the_other_hand_and_both_may_hold_one_thing():
    both = lift(hands=("left",)) + HOLD.format(hand="right", start=0.6, end=1.0)
    clip = recordings.from_text(both, name="both")
    mirrored = mirrored_tables(table_of(both, "both"), clip.figure, Mirror.of(clip.figure))
    other = recordings.from_text(text_of(mirrored), name="other")
    one, two = ([(name_of(made, each), each.last) for each in made.context.schedule.grasps] for made in (clip, other))
    assert one == [("left_hand on crate", 1.5), ("right_hand on crate", 1.0)]
    assert two == [("right_hand on crate", 1.5), ("left_hand on crate", 1.0)]
    starts = (spot_of(made.context.schedule.grasps[0], 0.6)[0] for made in (other, clip))
    np.testing.assert_allclose(next(starts), next(starts) * [1, -1, 1], atol=1e-6)
