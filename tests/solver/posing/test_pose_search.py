"""What a search for a pose goes by: goals and bounds change as their rows say; steps are least squares by SciPy."""

from __future__ import annotations

from collections.abc import Callable

import mujoco
import numpy as np
import pytest
from figures import EVERY_JOINT, LEG, MIXED, figure_of
from oracles import placed
from scipy.spatial.transform import Rotation
from site_goal import SiteGoal

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.penalty import Bend, BendLimits
from dynsplines.solver.posing import MET, BodyGoal, Goal, PointGoal, Posed, PoseSearch, entries, limb, posed
from dynsplines.solver.posing.bounds import INSIDE, STRAIGHT, Bends, Ranges
from dynsplines.solver.posing.inverse_kinematics import _posed
from dynsplines.solver.posing.pose_search import BENT, PER_METRE, TRUNK
from dynsplines.solver.surface.points import Point, site_points

RANGED = """
<mujoco><compiler angle="radian"/><worldbody><body name="trunk" pos="0 0 1"><freejoint/><geom size=".1"/>
  <body name="arm" pos="0 .2 .4" quat=".9 .1 -.2 .3"><joint name="shoulder" type="ball" range="0 1.2"/>
    <geom size=".1" pos=".3 0 0"/>
    <body name="fore" pos=".3 0 0"><joint name="elbow" type="hinge" axis="0 1 0" range="-.1 2"/><geom size=".1"/>
      <body name="rod" pos=".3 0 0"><joint name="reach" type="slide" axis="1 0 0" range="-.4 .1"/><geom size=".05"/>
        <site name="tip" pos=".1 .02 .03"/></body></body></body>
  <body name="leg" pos="0 -.2 0"><joint name="hip" type="hinge" axis="0 1 0" range="-2 .2"/><geom size=".1"/>
    <body name="shin" pos="0 0 -.4" quat=".7 .1 .2 -.1"><joint name="knee" type="ball"/><geom size=".1" pos="0 0 -.2"/>
      <body name="foot" pos="0 0 -.4"><joint name="free" type="hinge" axis="1 0 0"/><geom size=".1"/>
        <site name="toe" pos=".1 0 0"/></body></body></body>
</body></worldbody></mujoco>"""


def somewhere(model: mujoco.MjModel, rng: np.random.Generator, size: float = 1.0) -> Array:
    qpos = np.array(model.qpos0)
    mujoco.mj_integratePos(model, qpos, size * rng.normal(size=model.nv), 1.0)
    return qpos


def differences(model: mujoco.MjModel, qpos: Array, values: Callable[[Array], Array], h: float = 1e-6) -> Array:
    """(k, nv): how values of a pose change along every velocity."""
    columns = []
    for direction in np.eye(model.nv):
        ends = np.array(qpos), np.array(qpos)
        for end, way in zip(ends, (h, -h), strict=True):
            mujoco.mj_integratePos(model, end, direction, way)
        columns.append((values(ends[0]) - values(ends[1])) / (2 * h))
    return np.array(columns).T


def assert_rows(goal: Goal, model: mujoco.MjModel, qpos: Array, atol: float = 1e-7) -> None:
    expected = differences(model, qpos, lambda at: np.array(goal.missed(model, placed(model, at))))
    np.testing.assert_allclose(goal.rows(model, placed(model, qpos)), expected, atol=atol)


@pytest.mark.parametrize("free", [(), (0,), (2,), (0, 1)])
def test_points_and_sites_miss_what_mujoco_has_between_them_and_their_place_along_the_axes_that_are_given(free, rng):
    figure = figure_of(LEG)
    model, position = figure.model, rng.normal(size=3)
    position[list(free)] = np.nan
    given = np.delete(np.arange(3), free)
    for name in ("heel", "toe"):  # a heel on a body that is welded on, and turned
        qpos = somewhere(model, rng)
        data, (point,) = placed(model, qpos), site_points(figure, [name])
        expected = (data.site(name).xpos - position)[given]
        for goal in (SiteGoal(name, position), PointGoal.of(figure, point, position)):
            np.testing.assert_allclose(goal.missed(model, data), expected, atol=1e-12)
            assert_rows(goal, model, qpos)
        plain = PointGoal.of(figure, point)
        np.testing.assert_allclose(plain.missed(model, data), data.site(name).xpos, atol=1e-12)
        np.testing.assert_allclose(plain.place(data), data.site(name).xpos, atol=1e-12)
        assert plain.bodies(model) == [figure.links[point.link].body]


@pytest.mark.parametrize("text", [MIXED, EVERY_JOINT, LEG])
def test_a_body_misses_its_rotation_by_scipys_rotation_vector_which_changes_as_its_rows_say(text, rng):
    model = figure_of(text).model
    qpos, body = somewhere(model, rng), model.nbody - 1
    data, turn = placed(model, qpos), Rotation.random(None, np.random.default_rng(3))
    x, y, z, w = turn.as_quat()
    goal = BodyGoal(model.body(body).name, np.array([w, x, y, z]))
    here = Rotation.from_matrix(data.xmat[body].reshape(3, 3))
    np.testing.assert_allclose(goal.missed(model, data), (here * turn.inv()).as_rotvec(), atol=1e-9)
    there = BodyGoal("by number", np.array(data.xquat[body]), body)
    assert there.bodies(model) == goal.bodies(model) == [body]
    np.testing.assert_allclose(there.missed(model, data), 0, atol=1e-9)
    assert_rows(there, model, qpos)


def test_a_body_that_leans_misses_upright_by_its_lean_about_the_axis_that_it_leans_about(rng):
    figure = figure_of(LEG)
    model, heading, lean = figure.model, Rotation.from_rotvec([0, 0, 0.8]), np.array([0.3, -0.5, 0.0])
    qpos = np.array(model.qpos0)
    x, y, z, w = (Rotation.from_rotvec(lean) * heading).as_quat()
    qpos[3:7] = w, x, y, z
    goal = BodyGoal("foot")  # turned at rest already
    np.testing.assert_allclose(goal.missed(model, placed(model, qpos)), lean[:2], atol=1e-12)
    x, y, z, w = heading.as_quat()
    qpos[3:7] = w, x, y, z
    np.testing.assert_allclose(goal.missed(model, placed(model, qpos)), [0, 0], atol=1e-12)
    nearly = np.array(qpos)
    mujoco.mj_integratePos(model, nearly, np.eye(model.nv)[3], 1e-5)
    assert_rows(goal, model, nearly, atol=2e-5)


def ranges_of(figure: Figure, beyond: float = 0.0) -> Ranges:
    return Ranges.of(figure, list(range(2, len(figure.links))), np.arange(6, figure.model.nv), beyond)


@pytest.mark.parametrize("beyond", [0.0, 0.3])
def test_joints_are_over_their_ranges_by_what_mujoco_says_less_what_they_may_be_and_a_hair(beyond, rng):
    figure = figure_of(RANGED)
    model, ranges = figure.model, ranges_of(figure, beyond)
    for _ in range(20):
        qpos = somewhere(model, rng)
        over, rows = ranges.linearised(qpos)
        expected = differences(model, qpos, lambda at: ranges.linearised(at)[0])
        np.testing.assert_allclose(rows, expected[:, 6:], atol=1e-6)
        assert not expected[:, :6].any()
        columns = [model.joint(name).qposadr[0] for name in ("elbow", "reach", "hip")]
        slides = np.array([False, True, False])
        low, high = np.array([[-0.1, 2], [-0.4, 0.1], [-2, 0.2]]).T
        spare = INSIDE - beyond * ~slides
        shoulder = model.joint("shoulder").qposadr[0]
        turn = Rotation.from_quat(qpos[shoulder : shoulder + 4], scalar_first=True)
        found = [turn.magnitude() - 1.2 + INSIDE - beyond]
        found += [*(qpos[columns] - high + spare), *(low - qpos[columns] + spare)]
        np.testing.assert_allclose(over, found, atol=1e-9)


def test_a_search_begins_inside_the_ranges_with_hinges_that_rest_near_one_end_bent_away_from_it(rng):
    figure = figure_of(RANGED)
    model, ranges = figure.model, ranges_of(figure)
    elbow, reach, hip = (model.joint(name).qposadr[0] for name in ("elbow", "reach", "hip"))
    for _ in range(20):
        qpos = somewhere(model, rng, 2.0)
        begun = ranges.begun(qpos, 0.7)
        assert begun[elbow] == pytest.approx(np.clip(max(qpos[elbow], -0.1 + 0.7), -0.1, 2), abs=2e-5)
        assert begun[hip] == pytest.approx(np.clip(min(qpos[hip], 0.2 - 0.7), -2, 0.2), abs=2e-5)
        assert begun[reach] == pytest.approx(np.clip(qpos[reach], -0.4, 0.1), abs=2e-5)
        others = np.setdiff1d(np.arange(model.nq), [elbow, reach, hip])
        np.testing.assert_array_equal(begun[others], qpos[others])
        assert ranges.linearised(begun)[0][1:].max() <= 1e-12


def bends_of(figure: Figure) -> Bends:
    knee = next(i for i, link in enumerate(figure.links) if link.name == "knee")
    joints = (Bend("knee", knee, np.array([0.0, 1, 0]), np.array([0.0, 0, -1])),)
    found = Bends.of(figure, BendLimits(joints, 0.1, 0.2, 0.3), np.ones(figure.model.nq, bool))
    assert found is not None
    return found


def test_bends_change_as_their_rows_say_and_are_over_their_bounds_by_the_joints_own_angles(rng):
    figure = figure_of(RANGED)
    model, bends = figure.model, bends_of(figure)
    knee = entries(figure, bends.limits.joints[0].link)
    for _ in range(10):
        qpos = somewhere(model, rng, 0.4)
        (crooked, by_crooked), (over, by_over) = bends.linearised(qpos, model.nv)
        expected = differences(model, qpos, lambda at: np.concatenate([p[0] for p in bends.linearised(at, model.nv)]))
        np.testing.assert_allclose(np.concatenate([by_crooked, by_over]), expected, atol=1e-6)
        flexion, sideways, twist = bends._angles(qpos[knee][None])[:, 0]
        np.testing.assert_allclose(crooked, STRAIGHT * np.array([sideways, twist]), atol=1e-9)
        limits = [0.1 - flexion, sideways - 0.2, -sideways - 0.2, twist - 0.3, -twist - 0.3]
        np.testing.assert_allclose(over, np.array(limits) + INSIDE, atol=1e-9)


def test_a_joint_that_bends_less_than_it_begins_with_is_bent_that_far_about_its_lateral_axis(rng):
    figure = figure_of(RANGED)
    bends = bends_of(figure)
    knee = entries(figure, bends.limits.joints[0].link)
    turn = figure.links[bends.limits.joints[0].link].turn
    for angle in (-0.8, 0.0, 0.5, 0.9, 1.4):
        qpos = np.array(figure.model.qpos0)
        bent = quat.from_rotation_vector(quat.rotated(quat.inverse(turn), np.array([0, angle, 0.0])))
        qpos[knee] = 1.7 * bent
        begun = bends.begun(qpos, 0.9)
        assert bends._angles(begun[knee][None])[0, 0] == pytest.approx(max(angle, 0.9))
        np.testing.assert_allclose(bends._angles(begun[knee][None])[1:, 0], 0, atol=1e-9)
        np.testing.assert_array_equal(np.delete(begun, knee), np.delete(qpos, knee))


def test_what_is_free_weighs_a_metre_as_five_radians_and_a_joint_where_limbs_branch_off_more(rng):
    figure = figure_of(RANGED)
    free = np.ones(figure.model.nq, bool)
    free[1] = False  # the root's y
    goals = (SiteGoal("tip", np.zeros(3)), SiteGoal("toe", np.zeros(3)))
    search = PoseSearch(figure, np.array(figure.model.qpos0), free, goals, None)
    names = {link.name: link.dof for link in figure.links[1:]}
    weigh = dict(zip(search.dofs.tolist(), search.weights, strict=True))
    root = figure.links[1]
    assert root.kind is JointKind.FREE
    assert sorted(weigh) == [0, *range(2, figure.model.nv)]
    assert [weigh[k] for k in (0, 2)] == [PER_METRE] * 2
    assert [weigh[k] for k in (3, 4, 5)] == [TRUNK] * 3
    assert weigh[names["reach"]] == PER_METRE
    assert [weigh[names[name]] for name in ("shoulder", "elbow", "hip", "knee", "free")] == [1.0] * 5
    assert [figure.links[i].name for i in limb(figure, figure.model.body("rod").id)] == ["reach", "elbow", "shoulder"]


def test_what_a_search_adds_up_changes_as_its_rows_say(rng):
    """Away from home, from the goals and over the bounds, along every free velocity."""
    figure = figure_of(RANGED)
    home = somewhere(figure.model, rng, 0.2)
    knee = next(i for i, link in enumerate(figure.links) if link.name == "knee")
    bends = BendLimits((Bend("knee", knee, np.array([0.0, 1, 0]), np.array([0.0, 0, -1])),), 0.1, 0.2, 0.3)
    goals = (SiteGoal("tip", np.ones(3)), PointGoal.of(figure, Point("foot", len(figure.links) - 1, np.ones(3))))
    search = PoseSearch(figure, home, np.ones(figure.model.nq, bool), goals, bends)
    near = search.moved(home, 1e-3 * rng.normal(size=search.dofs.size))
    rows = np.concatenate([rows for _, rows in search.linearised(near)])
    expected = differences(
        figure.model, near, lambda at: np.concatenate([values for values, _ in search.linearised(at)])
    )
    np.testing.assert_allclose(rows, expected[:, search.dofs], atol=2e-2)
    np.testing.assert_allclose(rows[search.dofs.size :], expected[search.dofs.size :, search.dofs], atol=1e-5)


def searching(figure: Figure, home: Array, bends: BendLimits | None = None) -> PoseSearch:
    goals = (SiteGoal("tip", np.ones(3)), SiteGoal("toe", np.zeros(3)))
    return PoseSearch(figure, home, np.ones(figure.model.nq, bool), goals, bends)


@pytest.mark.parametrize("count", [0, 1, 2, 3, 7])
def test_as_many_poses_to_begin_with_as_asked_for_all_inside_the_ranges_and_the_root_where_it_was(count, rng):
    figure = figure_of(RANGED)
    home = somewhere(figure.model, rng)
    search = searching(figure, home)
    starts = list(search.starts_around(count))
    assert len(starts) == count
    for start in starts:
        np.testing.assert_array_equal(start[:3], home[:3])
        assert search.ranges.linearised(start)[0][1:].max() <= 1e-9
    if count > 0:
        ball = entries(figure, figure.link_named("knee") or 0)
        np.testing.assert_array_equal(starts[0][ball], figure.model.qpos0[ball])
        np.testing.assert_array_equal(starts[0][3:7], home[3:7])
    if count > 1:
        middle = figure.model.joint("reach").qposadr[0]
        assert starts[1][middle] == pytest.approx(-0.15)
    different = {tuple(np.round(start, 9)) for start in starts}
    assert len(different) == count
    again = list(searching(figure, home).starts_around(count))
    np.testing.assert_array_equal(again, starts)  # the same command finds the same pose


def test_scattered_poses_to_begin_with_bend_their_joints_by_something_between_the_least_and_the_most_of_starts(rng):
    figure = figure_of(RANGED)
    bends = bends_of(figure)
    search = searching(figure, somewhere(figure.model, rng), bends.limits)
    knee = entries(figure, bends.limits.joints[0].link)
    starts = list(search.starts_around(40))[2:]
    found = np.array([bends._angles(start[knee][None])[0, 0] for start in starts])
    assert found.min() >= BENT[0] - 1e-9
    assert found.min() < np.radians(30)
    least = np.unique(np.round(found[found < BENT[-1]], 6))
    assert least.size > 20, "drawn anew every time"


def test_poses_to_begin_with_are_home_bent_less_and_more_or_home_alone_where_nothing_bends_one_way(rng):
    figure = figure_of(RANGED)
    home = np.array(figure.model.qpos0)
    angles = [start[figure.model.joint("elbow").qposadr[0]] for start in searching(figure, home).bent_starts()]
    assert len(angles) == 3
    assert np.all(np.diff(angles) > 0.3)
    free = figure_of(RANGED.replace('range="-.1 2"', "").replace('range="-2 .2"', ""))
    (alone,) = searching(free, np.array(free.model.qpos0)).bent_starts()
    np.testing.assert_allclose(alone, free.model.qpos0, atol=2e-5)


def test_a_joint_keyed_in_the_middle_of_its_range_or_without_one_bends_either_way():
    text = RANGED.replace('range="-.1 2"', 'range="{}"')
    for limits, way in (("-.1 2", 1), ("-2 .1", -1), ("-1 1", 0), ("-.49 1.5", 1), ("-.51 1.5", 0)):
        figure = figure_of(text.format(limits))
        ranges = ranges_of(figure)
        elbow = figure.model.joint("elbow").qposadr[0]
        assert ranges.ways[list(ranges.simple).index(elbow)] == way


@pytest.mark.parametrize("starts", [1, 3, 5])
def test_a_pose_out_of_reach_tells_how_many_were_begun_with_and_one_in_reach_none(starts):
    figure = figure_of(RANGED)
    free = np.ones(figure.model.nq, bool)
    free[:7] = False
    home = np.array(figure.model.qpos0)
    mid = somewhere(figure.model, np.random.default_rng(3), 0.0)
    for name, by in (("elbow", 0.8), ("reach", -0.1)):
        mid[figure.model.joint(name).qposadr[0]] = by
    near = placed(figure.model, mid).site("tip").xpos
    found = posed(figure, home, free, [SiteGoal("tip", near)], starts=starts)
    assert found.is_met
    assert found.starts == 0
    assert found.worst <= MET
    far = posed(figure, home, free, [SiteGoal("tip", near + 5.0)], starts=starts)
    assert not far.is_met
    assert far.starts == starts
    assert far.worst == pytest.approx(far.missed[0])
    seen = placed(figure.model, far.qpos).site("tip").xpos
    assert far.missed[0] == pytest.approx(np.linalg.norm(seen - near - 5.0))
    np.testing.assert_array_equal(far.qpos[:7], home[:7])


class Scripted:
    """A search that ends as it is told to: by start, how far it misses."""

    home, dofs = np.zeros(1), np.zeros(3)

    def __init__(self, *missed: float) -> None:
        self.missed = missed

    def result(self, qpos: Array) -> Posed:
        miss = 9.0 if qpos[0] == 0 else self.missed[int(qpos[0]) - 1]
        return Posed(qpos, np.ones(1, bool), np.array([miss]))

    def bent_starts(self) -> list[Array]:
        return [np.array([k]) for k in (1.0, 2.0)]

    def roughly(self, start: Array) -> tuple[Array, float]:
        return start, float(start[0])

    def around(self, start: Array) -> Array:
        return start

    def starts_around(self, count: int) -> list[Array]:
        return [np.array([k]) for k in range(3, 3 + count)]

    followed = exactly = result


@pytest.mark.parametrize("meets", [1, 2, 3, 4, 5])
def test_the_first_pose_that_meets_its_goals_is_taken_whichever_start_led_to_it(meets):
    missed = [0.0 if k >= meets else 1.0 / k for k in range(1, 6)]
    found = _posed(Scripted(*missed), 5)  # type: ignore[arg-type]
    assert found.is_met
    assert found.qpos[0] == meets


def test_where_none_does_the_nearest_is_taken_and_all_starts_are_told():
    found = _posed(Scripted(0.5, 0.7, 0.2, 0.4, 0.6), 5)  # type: ignore[arg-type]
    assert (found.qpos[0], found.worst, found.starts) == (3, 0.2, 5)
    fewer = _posed(Scripted(0.5, 0.7, 0.2), 2)  # type: ignore[arg-type]
    assert (fewer.qpos[0], fewer.starts) == (1, 2)


def test_how_far_a_pose_is_from_home_is_what_its_joints_have_moved_each_with_its_weight(rng):
    figure = figure_of(RANGED)
    home, pose = (somewhere(figure.model, rng, 0.4) for _ in range(2))
    search = searching(figure, home)
    (near, rows), _, _ = search.linearised(pose)
    moved = np.zeros(figure.model.nv)
    moved[:3] = pose[:3] - home[:3]
    for link in figure.links[1:]:
        if link.kind in (JointKind.HINGE, JointKind.SLIDE):
            moved[link.dof] = pose[link.qpos] - home[link.qpos]
        else:
            at = link.qpos + (3 if link.kind is JointKind.FREE else 0)
            before, after = (Rotation.from_quat(q[at : at + 4], scalar_first=True) for q in (home, pose))
            first = link.dof + (3 if link.kind is JointKind.FREE else 0)
            moved[first : first + 3] = (before.inv() * after).as_rotvec()
    np.testing.assert_allclose(near, search.weights * moved[search.dofs], atol=1e-9)
    np.testing.assert_array_equal(rows, np.diag(search.weights))


def test_a_limb_goes_up_to_where_another_branches_off_and_a_trunk_is_its_own():
    figure = figure_of(RANGED)
    for body, names in (("trunk", 1), ("foot", 3), ("shin", 2), ("arm", 1)):
        own = limb(figure, figure.model.body(body).id)
        assert len(own) == names
        assert own[0] == figure.body_link[figure.model.body(body).id]
