"""BVH: other readers find every joint where MuJoCo has it; other makers' skeletons and files that are cut are read."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import permutations
from pathlib import Path

import motions
import mujoco
import numpy as np
import pytest
import shipped
from oracles import kinematics
from scipy.spatial.transform import Rotation
from texts import read_cases, read_data

from dynsplines import models
from dynsplines.clip.table import MapTable
from dynsplines.errors import UserError
from dynsplines.exchange import formats, gaps
from dynsplines.exchange.formats import bvh
from dynsplines.exchange.motion_import import import_recording
from dynsplines.exchange.skeleton import bvh_file, hierarchy, maps, retarget
from dynsplines.exchange.skeleton.bvh_file import Joint, Skeleton
from dynsplines.exchange.skeleton.captured_skeleton import CapturedSkeleton
from dynsplines.motion import Bodies, Sampled
from dynsplines.solver import quaternion as quat
from dynsplines.system.progress import Progress

TENTH = 1e-4  # [m]
ARMS = ("left_upper_arm", "left_forearm", "right_upper_arm", "right_forearm")


@pytest.fixture(scope="module")
def cartwheel():
    return Sampled.of(shipped.unsolved("cartwheel"), 5.0)


@pytest.fixture(scope="module")
def walk():
    return Sampled.of(shipped.unsolved("walk_loop"), 8.0)


def y_up(take):
    """(T, nbody, 3) [cm] MuJoCo's places in the file's axes."""
    return 100 * take.bodies.position[..., [1, 2, 0]]


def lift(after, before):
    """(3,) by how much all was raised, so that soles met the ground; nothing else may differ.

    Raw splines, which these are, have feet some centimetres in the ground.
    """
    shift = np.array([0, 0, (after[:, 1] - before[:, 1])[:, 2].mean()])
    assert 0 <= shift[2] < 0.04
    return shift


def written(take, folder):
    return formats.export(take.motion, "bvh", folder / "a.bvh", fps=take.fps)


def by_hand(skeleton, sample):
    """{name: (3,)} by 4 x 4 matrices, straight from the description of the format."""
    column, world, out = 0, [], {}
    for joint in skeleton.joints:
        place, turn = joint.offset.copy(), np.eye(3)
        for channel in joint.channels:
            value, axis = skeleton.values[sample, column], "XYZ".index(channel[0])
            column += 1
            if "position" in channel:
                place[axis] = value
            else:
                c, s = np.cos(np.radians(value)), np.sin(np.radians(value))
                around = np.eye(3)
                j, k = (axis + 1) % 3, (axis + 2) % 3
                around[[j, j, k, k], [j, k, j, k]] = [c, -s, s, c]
                turn = turn @ around
        matrix = np.eye(4)
        matrix[:3, :3], matrix[:3, 3] = turn, place
        world.append(matrix if joint.parent < 0 else world[joint.parent] @ matrix)
        out[joint.name] = world[-1][:3, 3]
    return out


def test_every_joint_and_several_figures_are_where_mujoco_has_them(tmp_path):
    """Slides and joints beside their bodies' origins have positions; turned rest poses are baked in."""
    take = Sampled.of(motions.moved(), 48.0)
    found = bvh_file.read(written(take, tmp_path))
    assert found.fps == 48.0
    names = hierarchy.names(take.model)
    for sample in (0, 7, len(take.time) - 1):
        for name, place in by_hand(found, sample).items():
            truth = y_up(take)[sample, names.index(name)] if name != "world" else np.zeros(3)
            np.testing.assert_allclose(place, truth, atol=100 * TENTH, err_msg=name)
    moving = {joint.name for joint in found.joints if len(joint.channels) == 6}
    assert moving == {"world", "hips", "right_thigh", "body5"}


@pytest.mark.slow
def test_of_several_figures_the_one_with_limbs_is_read(tmp_path, capsys):
    """The first moves freely under a common root, so its travel can be kept only without that root."""
    take = Sampled.of(motions.moved(), 48.0)
    path = written(take, tmp_path)
    back = Sampled.of(import_recording(path, scale=0.01, progress=Progress()), 48.0)
    assert back.time.size == take.time.size
    assert [back.model.body(i).name for i in range(2)] == ["world", "hips"]
    travel = [np.ptp(each.bodies.position[:, each.model.body("hips").id, :2], axis=0) for each in (back, take)]
    np.testing.assert_allclose(*travel, atol=TENTH)
    note = "'hips' is the root; its parents are folded into it: world; other branches are left out: swing"
    assert note in capsys.readouterr().err


@pytest.mark.slow
def test_our_own_file_comes_back_on_our_own_figure(cartwheel, tmp_path):
    back = Sampled.of(import_recording(written(cartwheel, tmp_path), figure="human"))
    assert back.fps == cartwheel.fps
    before, after = cartwheel.bodies.position[:, 1:], back.bodies.position[:, 1:]
    np.testing.assert_allclose(after - lift(after, before), before, atol=TENTH)
    assert quat.angle_between(back.bodies.rotation, cartwheel.bodies.rotation).max() < 1e-6


@pytest.mark.slow
def test_a_figure_of_its_own_has_every_joint_where_the_file_has_it(cartwheel, tmp_path):
    back = Sampled.of(import_recording(written(cartwheel, tmp_path)))
    names = [cartwheel.model.body(body).name for body in range(1, cartwheel.model.nbody)]
    before = cartwheel.bodies.position[:, 1:]
    after = back.bodies.position[:, [back.model.body(name).id for name in names]]
    np.testing.assert_allclose(after - lift(after, before), before, atol=TENTH)
    sites = {back.model.site(i).name for i in range(back.model.nsite)}
    assert sites == {"left_heel", "left_toe", "right_heel", "right_toe"}
    ours, theirs = kinematics(cartwheel.model, cartwheel.qpos[0]), kinematics(back.model, back.qpos[0])
    shift = lift(after, before)
    for site in sites:
        np.testing.assert_allclose(theirs.site(site).xpos - shift, ours.site(site).xpos, atol=0.04)
    assert 20 < back.model.body_subtreemass[1] < 120
    assert {int(kind) for kind in back.model.jnt_type} == {0, 1}


MIXAMO = {
    "pelvis": "mixamorig:Hips", "chest": "mixamorig:Spine2", "left_upper_arm": "mixamorig:LeftArm",
    "left_forearm": "mixamorig:LeftForeArm", "right_upper_arm": "mixamorig:RightArm",
    "right_forearm": "mixamorig:RightForeArm", "left_thigh": "mixamorig:LeftUpLeg", "left_shin": "mixamorig:LeftLeg",
    "left_foot": "mixamorig:LeftFoot", "right_thigh": "mixamorig:RightUpLeg", "right_shin": "mixamorig:RightLeg",
    "right_foot": "mixamorig:RightFoot",
}  # fmt: skip
PLACES = ("Xposition", "Yposition", "Zposition")


def t_pose() -> dict[str, np.ndarray]:
    """How a T-pose turns the arms out of ours, in which they hang."""
    out = {}
    for side, sign in (("left", 1.0), ("right", -1.0)):
        for part in ("upper_arm", "forearm"):
            out[f"{side}_{part}"] = quat.from_rotation_vector(np.array([sign * np.pi / 2, 0, 0]))
    return out


def disguised(
    take: Sampled,
    *,
    zero: Mapping[str, np.ndarray] | None = None,
    unit: float = 0.01,
    orders: Sequence[str] = ("ZXY", "YXZ", "XYZ", "ZYX", "YZX", "XZY"),
    z_up: bool = False,
    every_place: bool = False,
    larger: float = 1.0,
) -> Skeleton:
    """The human's motion as other programs write it: with other names, zero poses, axes and units.

    zero: by body, its rotation (4,) in the pose where all angles are nought, from our rest
    unit [m]; orders, in turn; every_place: positions for all joints, not just the root; larger: all but the angles
    """
    model, zero = take.model, zero or {}

    def theirs(vector):
        return vector if z_up else np.roll(vector, -1, axis=-1)

    def turned(q):
        return np.concatenate([q[..., :1], theirs(q[..., 1:])], axis=-1)

    bodies = [b for b in range(1, model.nbody) if model.body_weldid[b]]
    zeros = {b: zero.get(model.body(b).name, np.array([1.0, 0, 0, 0])) for b in bodies}
    world = {b: quat.product(take.bodies.rotation[:, b], quat.conjugate(zeros[b])) for b in bodies}
    joints, columns = [], []
    for i, body in enumerate(bodies):
        order, parent = orders[i % len(orders)], int(model.body_parentid[body])
        offset = (
            larger / unit * theirs(quat.rotate(zeros.get(parent, zeros[body]), model.body_pos[body]))
            if i
            else np.zeros(3)
        )
        sites = np.flatnonzero(model.site_bodyid == body)
        leaf = body not in model.body_parentid[bodies]
        end = larger / unit * theirs(quat.rotate(zeros[body], model.site_pos[sites[-1]])) if leaf else None
        places = PLACES if i == 0 or every_place else ()
        name = MIXAMO.get(model.body(body).name, model.body(body).name)
        joints.append(
            Joint(
                name, bodies.index(parent) if i else -1, offset, (*places, *(f"{axis}rotation" for axis in order)), end
            )
        )
        local = quat.product(quat.conjugate(world[parent]), world[body]) if i else world[body]
        if places:
            root = larger / unit * theirs(take.bodies.position[:, body])
            columns.append(root if i == 0 else np.tile(offset, (len(root), 1)))
        columns.append(np.degrees(hierarchy.euler_angles(turned(local)[:, None], order.lower())[:, 0]))
    return Skeleton(tuple(joints), take.fps, np.concatenate(columns, axis=1))


@pytest.mark.slow
@pytest.mark.parametrize(
    "other", [{}, {"larger": 1.3, "z_up": True}, {"unit": 0.001, "orders": ["XYZ"], "every_place": True}]
)
def test_a_t_pose_skeleton_of_any_unit_and_axes_moves_our_figure_alike(other, walk, tmp_path):
    path = tmp_path / "t.bvh"
    path.write_text(bvh_file.text_of(disguised(walk, zero=t_pose(), **other)))
    back = Sampled.of(import_recording(path, figure="human"))
    shift = back.bodies.position[:, 1] - walk.bodies.position[:, 1]
    if "larger" not in other:
        np.testing.assert_allclose(shift - shift[0] * [0, 0, 1], 0, atol=TENTH)
        assert 0 <= shift[0, 2] < 0.04
    moved = back.bodies.position - walk.bodies.position - shift[:, None]
    np.testing.assert_allclose(moved[:, 1:], 0, atol=0.001)
    turned = quat.angle_between(back.bodies.rotation[:, 1:], walk.bodies.rotation[:, 1:])
    assert np.degrees(turned.max()) < 1


@pytest.mark.slow
@pytest.mark.parametrize(
    ("unmapped", "off"),
    [
        ((), {"pelvis": 3, "chest": 3}),
        (("chest", "neck", "head"), {"pelvis": 6}),
        ((*ARMS, "neck", "head"), {"pelvis": 6, "chest": 15}),
    ],
    ids=["whole", "without chest and head", "without arms and head"],
)
def test_a_skeleton_whose_zero_pose_means_nothing_still_points_its_limbs_alike(walk, rng, unmapped, off):
    """As LAFAN1's: directions of limbs come from the motion; a forearm's own twist may differ."""
    model = walk.model
    zero = {model.body(b).name: quat.normalise(rng.normal(size=4)) for b in range(1, model.nbody)}
    with maps.using(MapTable(recording=dict.fromkeys(unmapped, ""))):
        qpos, _ = retarget.onto(CapturedSkeleton.of(disguised(walk, zero=zero)), model, "a.bvh")
    back = Bodies.of(model, qpos, np.zeros((len(qpos), model.nv)))
    shift = back.position[:, 1] - walk.bodies.position[:, 1]
    turned = np.degrees(quat.angle_between(back.rotation, walk.bodies.rotation)).max(axis=0)
    if not unmapped:
        moved = (back.position - walk.bodies.position - shift[:, None])[:, 1:]
        np.testing.assert_allclose(moved, 0, atol=0.002)
        assert turned.max() < 20
    for name, most in (off | dict.fromkeys(("left_thigh", "right_shin", "left_foot", "right_foot"), 3)).items():
        assert turned[model.body(name).id] < most, name


@pytest.mark.parametrize("joint", [1, 4])
def test_a_bone_that_changes_its_length_by_more_than_a_centimetre_is_named(walk, joint):
    skeleton = disguised(walk, every_place=True)
    assert not any("bones keep their lengths" in note for note in CapturedSkeleton.of(skeleton).notes)
    values, column = skeleton.values.copy(), sum(len(each.channels) for each in skeleton.joints[:joint])
    values[:, column + 1] += np.linspace(0, 4, len(values))  # [cm]
    notes = CapturedSkeleton.of(replace(skeleton, values=values)).notes
    (note,) = (note for note in notes if "bones keep their lengths" in note)
    assert note.endswith(f"left out: {skeleton.names[joint]}")


@pytest.mark.slow
def test_bones_of_other_lengths_bring_hands_and_feet_to_scaled_places_and_the_feet_to_the_ground(cartwheel):
    """Feet about hips, by the legs' ratio, 1.147; hands about shoulders as they were; the trunk is turned as it was."""
    spec = mujoco.MjSpec.from_string(models.figure_text("human"))
    for name in ("left_shin", "right_shin"):
        spec.body(name).pos *= 1.3
    model = spec.compile()
    qpos, notes = retarget.onto(CapturedSkeleton.of(bvh.skeleton(cartwheel)), model, "a.bvh")
    back = Bodies.of(model, qpos, np.zeros((len(qpos), model.nv)))
    assert any("scaled by 1.147" in note for note in notes), notes
    for side in ("left", "right"):
        for first, last, scale in (("thigh", "foot", 1.147), ("upper_arm", "forearm", 1.0)):
            one, other = (model.body(f"{side}_{part}").id for part in (first, last))
            about = [scene.position[:, other] - scene.position[:, one] for scene in (cartwheel.bodies, back)]
            off = np.linalg.norm(about[1] - scale * about[0], axis=1)
            assert np.percentile(off, 90) < 0.005, (side, last, off.max())
    trunk = [model.body(name).id for name in ("pelvis", "chest")]
    turned = quat.angle_between(back.rotation[:, trunk], cartwheel.bodies.rotation[:, trunk])
    assert turned.max() < 1e-5
    soles = [model.site(f"{side}_{part}").id for side in ("left", "right") for part in ("heel", "toe")]
    lowest = [kinematics(model, row).site_xpos[soles, 2].min() for row in qpos]
    assert abs(np.percentile(lowest, 2)) < 0.002


@pytest.mark.slow
@pytest.mark.parametrize(("height", "word"), [(0.3, "lowered by 0."), (-0.3, "raised by 0.")])
def test_a_recording_above_or_below_the_ground_is_brought_to_it(cartwheel, height, word):
    captured = CapturedSkeleton.of(bvh.skeleton(cartwheel))
    moved = captured.position[:3] + np.array([0, 0, height])
    captured = replace(captured, position=moved, rotation=captured.rotation[:3])
    qpos, notes = retarget.onto(captured, cartwheel.model, "a.bvh")
    assert any(note.startswith(word) for note in notes), notes
    model = cartwheel.model
    soles = [model.site(f"{side}_{part}").id for side in ("left", "right") for part in ("heel", "toe")]
    assert abs(min(kinematics(model, row).site_xpos[soles, 2].min() for row in qpos)) < 0.005


def with_toes(take: Sampled, bend: np.ndarray) -> Skeleton:
    """The human's motion on a skeleton whose feet have toes in their front third, bent up by angles (T,) [rad]."""
    found = bvh.skeleton(take)
    joints, columns, at = [], [], 0
    moved: dict[int, int] = {}
    for i, joint in enumerate(found.joints):
        moved[i] = len(joints)
        width = len(joint.channels)
        columns.append(found.values[:, at : at + width])
        at += width
        parent = -1 if joint.parent < 0 else moved[joint.parent]
        joints.append(replace(joint, parent=parent))
        if joint.name.endswith("_foot"):
            assert joint.end is not None
            ball = np.array([0.0, joint.end[1], 0.7 * joint.end[2]])
            joints[-1] = replace(joint, parent=parent, end=None)
            toe = joint.name.replace("foot", "toe")
            joints.append(Joint(toe, moved[i], ball, ("Xrotation", "Yrotation", "Zrotation"), joint.end - ball))
            columns.append(np.stack([-np.degrees(bend), 0 * bend, 0 * bend], axis=1))
    return Skeleton(tuple(joints), found.fps, np.concatenate(columns, axis=1))


@pytest.mark.slow
def test_toes_turn_the_feet_of_a_figure_that_has_none(cartwheel):
    """The foot points to where the toes end: straight ones change nothing, raised ones raise the figure's."""
    count = len(cartwheel.time)
    model, angles = cartwheel.model, np.linspace(0, 0.9, count)
    seen = []
    for bend in (np.zeros(count), angles):
        qpos, notes = retarget.onto(CapturedSkeleton.of(with_toes(cartwheel, bend), 0.01), model, "a.bvh")
        assert any("the figure has no toes: what left_toe and right_toe bend turns its feet" in note for note in notes)
        assert not any("without a counterpart in the figure" in note for note in notes)
        seen.append(Bodies.of(model, qpos, np.zeros((count, model.nv))))
    straight, raised = seen
    assert quat.angle_between(straight.rotation[:, 1:], cartwheel.bodies.rotation[:, 1:]).max() < 1e-5
    for side in ("left", "right"):
        foot = model.body(f"{side}_foot").id
        end = 0.01 * np.array(next(j.end for j in bvh.skeleton(cartwheel).joints if j.name == f"{side}_foot"))
        ahead, below = 0.3 * end[2], 0.7 * end[2]
        tip = np.stack([below + ahead * np.cos(angles), end[1] + ahead * np.sin(angles)])
        expected = np.arctan2(tip[1], tip[0]) - np.arctan2(end[1], end[2])
        turned = quat.angle_between(raised.rotation[:, foot], straight.rotation[:, foot])
        np.testing.assert_allclose(turned, expected, atol=1e-5)
        own = quat.product(quat.conjugate(straight.rotation[:, foot]), raised.rotation[:, foot])
        assert np.all(own[angles > 0.1, 2] * own[angles > 0.1, 0] < 0)  # about −y of the foot: its tip goes up


GOOD = read_data("two_joints.bvh")


def test_a_rounded_frame_time_is_the_rate_that_is_meant(tmp_path):
    path = tmp_path / "good.bvh"
    path.write_text(GOOD.replace("Chest\n  {", "Chest {").replace("\n", "\r\n").replace("    {", "   {  "))
    assert bvh_file.read(path).fps == 120
    assert bvh_file.fps_of(0.033367, 6) == pytest.approx(30 / 1.001)
    assert bvh_file.fps_of(0.0333333, 7) == 30
    assert bvh_file.fps_of(0.017, 3) == 59
    assert bvh_file.fps_of(0.0810373, 7) == 1 / 0.0810373
    back = import_recording(path)
    assert back.fps == 120
    assert back.figure.model.nq == 11


@pytest.mark.parametrize(("old", "new", "line", "told"), read_cases("broken_bvh.toml"))
def test_a_broken_file_is_told_by_its_line(old, new, line, told, tmp_path):
    assert old in GOOD
    path = tmp_path / "bad.bvh"
    path.write_text(GOOD.replace(old, new, 1))
    with pytest.raises(UserError) as error:
        bvh_file.read(path)
    assert f"line {line}: " in str(error.value), error.value
    assert told in str(error.value), error.value
    assert "\n" not in str(error.value)


def test_a_file_cut_anywhere_is_told_and_never_a_traceback(tmp_path):
    path = tmp_path / "cut.bvh"
    for end in range(0, len(GOOD) - 30, 5):
        path.write_text(GOOD[:end])
        with pytest.raises(UserError, match=r"line \d+: "):
            bvh_file.read(path)


@pytest.mark.slow
def test_a_figure_or_file_without_legs_is_told(cartwheel, tmp_path):
    path = tmp_path / "good.bvh"
    path.write_text(GOOD)
    with pytest.raises(UserError, match=r"file's joints none is a left thigh or .* by its name: Hips, Chest"):
        import_recording(path, figure="human")
    with pytest.raises(UserError, match=r"figure's bodies none is a left thigh or .* by its name: body"):
        import_recording(written(cartwheel, tmp_path), figure="spinner")


@pytest.mark.slow
def test_the_unit_is_guessed_told_and_may_be_said(tmp_path, cartwheel):
    path, good, said = Path(written(cartwheel, tmp_path)), tmp_path / "good.bvh", []
    good.write_text(GOOD)

    class Ear(Progress):
        def report(self, line):
            said.append(line)

    import_recording(path, progress=Ear())
    import_recording(good, progress=Ear())
    assert "taken for centimetres: " in said[0]
    assert any("the longest limb reaches 0.90 m" in text for text in said)
    small = Sampled.of(import_recording(path, scale=0.001))
    np.testing.assert_allclose(np.ptp(small.qpos[:, 0]), 0.1 * np.ptp(cartwheel.qpos[:, 0]), atol=1e-6)
    with pytest.raises(UserError, match="it has its own times, 120 samples per second; --fps does not apply"):
        import_recording(good, fps=200)
    with pytest.raises(UserError, match="--scale does not apply"):
        formats.recording(Path(formats.export(cartwheel.motion, "csv", tmp_path / "a.csv")), scale=0.1)


@pytest.mark.parametrize(
    ("unit", "larger", "name"),
    [
        (1.0, 1.0, "metres"),
        (0.001, 1.0, "millimetres"),
        (0.0254, 1.0, "inches"),
        (0.0254 / 0.45, 1.3, "the CMU database's units"),
    ],
)
def test_of_units_that_fit_a_person_that_of_the_most_usual_size_is_taken(
    cartwheel, tmp_path, capsys, unit, larger, name
):
    (tmp_path / "a.bvh").write_text(bvh_file.text_of(disguised(cartwheel, unit=unit, larger=larger)))
    import_recording(tmp_path / "a.bvh", progress=Progress())
    assert f"taken for {name}: " in " ".join(capsys.readouterr().err.split())


def test_gaps_names_in_shift_jis_and_complete_last_lines(tmp_path):
    path = tmp_path / "a.bvh"
    path.write_bytes(GOOD.replace("Chest", "左足").rstrip("\n").encode("cp932"))
    assert bvh_file.read(path).names == ["Hips", "左足"]
    path.write_text(GOOD.replace("10 0 0 0 0\n", "1.#QNAN 0 0 0 0\n"))
    with gaps.allow():
        assert len(bvh_file.read(path).values) == 3
    head, rows = GOOD.split("83333\n")
    path.write_text(f"{head}83333\n" + re.sub(r" 0$", " null", rows, flags=re.MULTILINE))
    with gaps.allow(), pytest.raises(UserError, match=r"no sample has all numbers; write zeros for joints .*: Chest"):
        bvh_file.read(path)
    path.write_text(re.sub(r" 0$", " 0.125", GOOD, flags=re.MULTILINE)[:-3])
    with pytest.raises(UserError, match=r"line 21: the file ends within the number 0\.1; if it is complete"):
        bvh_file.read(path)


ORDERS = ["".join(order) for order in permutations("xyz")]


@pytest.mark.parametrize("order", ORDERS)
def test_angles_continue_through_the_lock_and_beyond_whole_turns(order):
    t = np.linspace(0, 1, 401)[:, None]
    smooth = np.concatenate([8 * t, np.pi * t, 0.3 - 9 * t], 1)  # the middle one passes 90° in sample 200, exactly
    found = hierarchy.euler_angles(quat.from_euler(smooth, order)[:, None], order)[:, 0]
    assert np.max(quat.angle_between(quat.from_euler(found, order), quat.from_euler(smooth, order))) < 1e-7
    own = Rotation.from_euler(order.upper(), found).as_matrix()
    turned = Rotation.from_quat(quat.from_euler(smooth, order), scalar_first=True).as_matrix()
    np.testing.assert_allclose(own, turned, atol=1e-7)
    np.testing.assert_allclose(found[:200], smooth[:200], atol=1e-7)
    np.testing.assert_allclose(found[:, 1], smooth[:, 1], atol=1e-6)
    assert np.max(np.abs(np.diff(found, axis=0))) < 0.06
