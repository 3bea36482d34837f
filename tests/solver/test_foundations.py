"""Quaternions, cones, caches, the C kernel and threads."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import dataclass

import figures
import numpy as np
import pytest
from figures import figure_of
from gradients import taylor_slope
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import SiteGoal, kinematics
from scipy.optimize import nnls
from scipy.spatial.transform import Rotation
from threadpoolctl import ThreadpoolController

from dynsplines import models, recordings
from dynsplines.clip import load
from dynsplines.clip import load as clips
from dynsplines.solver import compiled
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.cache import Cache, cache_key
from dynsplines.solver.cone import projection, unsupplied
from dynsplines.solver.figure.figure import Figure, quaternion_columns
from dynsplines.solver.figure.wrenches import VECTORS, Wrenches
from dynsplines.solver.one_thread import one_thread
from dynsplines.solver.posing import PointGoal, Posed, PoseSearch, inverse_kinematics, posed, reached
from dynsplines.solver.refine.subdivision import midpoints, split
from dynsplines.solver.search.quadratic import Layout, Model

component = st.floats(-2, 2, allow_nan=False).map(lambda x: round(x, 6))


few = settings(deadline=None, max_examples=25)


quaternions = st.tuples(*[component] * 4).map(np.array).filter(lambda q: np.linalg.norm(q) > 0.1)


vectors = st.tuples(*[component] * 3).map(np.array)


def scipy_rotation(q: np.ndarray) -> Rotation:
    return Rotation.from_quat(np.roll(q, -1, axis=-1))


def test_matrices_are_scipys_at_any_length(rng):
    q = rng.normal(size=(5, 4)) * np.array([[0.01], [0.3], [1.0], [7.0], [200.0]])
    np.testing.assert_allclose(quat.matrices(q), scipy_rotation(q).as_matrix(), atol=1e-12)


@few
@given(quaternions)
def test_a_quaternion_times_its_inverse_is_the_identity_on_both_sides(q):
    one = [1, 0, 0, 0]
    np.testing.assert_allclose(quat.product(q, quat.inverse(q)), one, atol=1e-13)
    np.testing.assert_allclose(quat.product(quat.inverse(q), q), one, atol=1e-13)
    np.testing.assert_array_equal(quat.product(q, one), q)
    np.testing.assert_array_equal(quat.product(one, q), q)


@few
@given(quaternions, quaternions, vectors)
def test_rotations_compose_and_turn_vectors_as_scipys_do(p, q, v):
    np.testing.assert_allclose(quat.rotated(q, v), scipy_rotation(q).apply(v), atol=1e-12)
    np.testing.assert_allclose(
        quat.rotated(quat.product(p, q), v), (scipy_rotation(p) * scipy_rotation(q)).apply(v), atol=1e-12
    )


@few
@given(quaternions)
def test_exponential_and_logarithm_are_inverse_and_agree_with_scipy(q):
    log = quat.rotation_vector(q)
    assert np.linalg.norm(log) <= np.pi + 1e-12
    back = quat.from_rotation_vector(log)
    unit = quat.normalised(q)
    np.testing.assert_allclose(back * np.sign(back @ unit), unit, atol=1e-12)
    if np.linalg.norm(log) < 3.1:
        np.testing.assert_allclose(log, scipy_rotation(q).as_rotvec(), atol=1e-12)


@pytest.mark.parametrize("angle", [0.0, 1e-320, 1e-170, 1e-12, 1.9e-9, 2.1e-9, 1e-6, 1e-3, 3.0])
def test_small_angles_keep_their_relative_accuracy_through_exponential_and_logarithm(angle):
    v = angle * np.array([0.6, 0.0, -0.8])
    np.testing.assert_allclose(quat.rotation_vector(quat.from_rotation_vector(v)), v, rtol=1e-13, atol=5e-324)


@pytest.mark.parametrize("gap", [1e-3, 1e-9, 1e-14, 0.0, -1e-14, -1e-9, -1e-3])
def test_angles_about_pi_come_back_as_the_same_rotation_by_the_short_way(gap):
    v = (np.pi - gap) * np.array([0.0, 1.0, 0.0])
    log = quat.rotation_vector(quat.from_rotation_vector(v))
    np.testing.assert_allclose(np.linalg.norm(log), np.pi - abs(gap), rtol=1e-13)
    np.testing.assert_allclose(np.abs(log[1]), np.pi - abs(gap), rtol=1e-13)


@few
@given(quaternions, st.floats(0, np.pi), vectors.filter(lambda v: np.linalg.norm(v) > 0.1))
def test_angle_between_is_the_angle_of_the_rotation_between_whatever_length_and_sign(q, angle, axis):
    turned = quat.product(q, quat.from_rotation_vector(angle * axis / np.linalg.norm(axis)))
    np.testing.assert_allclose(quat.angle_between(q, -3 * turned), angle, atol=1e-7)


def test_an_aligned_track_has_neighbours_on_one_hemisphere_and_the_same_rotations(rng):
    track = rng.normal(size=(40, 3, 4))
    aligned = quat.aligned(track)
    assert np.all(np.sum(aligned[1:] * aligned[:-1], axis=-1) >= 0)
    np.testing.assert_array_equal(np.abs(aligned), np.abs(track))
    np.testing.assert_array_equal(aligned[0], track[0])
    signs = aligned / track
    np.testing.assert_array_equal(signs, np.broadcast_to(signs[..., :1], signs.shape))
    assert (signs < 0).any()


@pytest.mark.parametrize("size", [1e-3, 1.0, 30.0])
@pytest.mark.parametrize("vector", [0.0, 1e-13, 1e-9, 1e-3, 1.0])
def test_the_rotation_vector_of_one_is_that_of_many_and_scipys(vector, size):
    rng = np.random.default_rng(3)
    for real in (1.0, -1.0, 1e-12):
        q = size * np.append(real, vector * rng.normal(size=3))
        one = quat.rotation_vector(q)
        np.testing.assert_allclose(one, quat.rotation_vector(q[None])[0], rtol=1e-12, atol=1e-300)
        np.testing.assert_allclose(one, Rotation.from_quat(q[[1, 2, 3, 0]]).as_rotvec(), rtol=1e-6, atol=1e-12)


def pyramids(rng: np.random.Generator, points: int, count: int) -> Array:
    """Friction pyramids at points about a metre under the centre of mass, some of them missing: (6, 4 points, S)."""
    places = rng.normal(size=(3, points, 1, count)) * np.array([0.2, 0.2, 0.02])[:, None, None, None]
    places[2] -= 1
    angles = np.pi / 4 + np.pi / 2 * np.arange(4)
    edges = np.array([0.8 * np.cos(angles), 0.8 * np.sin(angles), np.ones(4)])
    forces = np.broadcast_to(edges[:, None, :, None], (3, points, 4, count))
    both = np.concatenate([forces, np.cross(places + 0 * forces, forces, axis=0)]).reshape(6, -1, count)
    return both * np.repeat(rng.random((points, count)) < 0.7, 4, axis=0)


@pytest.mark.parametrize("softness", [1e-2, 1e-4, 1e-8])
@pytest.mark.parametrize("points", [1, 4, 8])
def test_it_is_the_least_squares_over_shares_that_are_not_negative(rng, points, softness):
    edges, w = pyramids(rng, points, 60), rng.normal(size=(6, 60))
    w[2] += 1
    found = unsupplied(w, edges, softness)
    for s in range(60):
        matrix = np.vstack([edges[:, :, s], np.sqrt(softness) * np.eye(edges.shape[1])])
        shares, size = nnls(matrix, np.append(w[:, s], np.zeros(edges.shape[1])))
        np.testing.assert_allclose(found.value[s], size**2, atol=1e-12)
        np.testing.assert_allclose(found.rest[:, s], w[:, s] - edges[:, :, s] @ shares, atol=1e-7)
        np.testing.assert_allclose(found.shares[:, s], shares, atol=1e-5)


@pytest.mark.parametrize("softness", [1e-4, 1e-8])
def test_thousands_of_cones_meet_the_optimality_conditions(rng, softness):
    edges, w = pyramids(rng, 8, 2000), rng.normal(size=(6, 2000))
    w[2] += 1
    found = unsupplied(w, edges, softness)
    pull = np.einsum("nks,ns->ks", edges, found.rest)
    np.testing.assert_allclose(softness * found.shares, np.maximum(pull, 0), atol=1e-12)
    np.testing.assert_allclose(found.rest, w - np.einsum("nks,ks->ns", edges, found.shares), atol=1e-6)


def test_without_edges_all_of_it_is_left(rng):
    w = rng.normal(size=(6, 5))
    for edges in (np.zeros((6, 8, 5)), np.zeros((6, 0, 5))):
        found = unsupplied(w, edges, 1e-4)
        np.testing.assert_array_equal(found.rest, w)
        np.testing.assert_allclose(found.value, np.sum(w**2, axis=0), rtol=1e-14)
        np.testing.assert_array_equal(projection(found, edges, 1e-4), np.tile(np.eye(6), (5, 1, 1)))


def test_what_lies_in_the_cone_is_supplied(rng):
    edges = pyramids(rng, 3, 20)
    w = np.einsum("nks,ks->ns", edges, rng.random((12, 20)))
    assert unsupplied(w, edges, 1e-10).value.max() < 1e-8
    assert unsupplied(-w, edges, 1e-10).value.max() > 0.1


def test_the_rest_and_the_shares_are_the_gradient(rng):
    edges, w = pyramids(rng, 4, 30), rng.normal(size=(6, 30))
    found = unsupplied(w, edges, 1e-3)
    by_edges = -2 * found.rest[:, None] * found.shares[None]
    assert found.shares.any()

    def value(point: Array) -> float:
        return float(unsupplied(point[:, 0], point[:, 1:], 1e-3).value.sum())

    point = np.concatenate([w[:, None], edges], axis=1)
    gradient = np.concatenate([2 * found.rest[:, None], by_edges], axis=1)
    assert taylor_slope(value, point, gradient, rng) > 1.9


def test_the_projection_is_how_the_rest_moves_with_the_vector(rng):
    edges, w, h = pyramids(rng, 2, 20), rng.normal(size=(6, 20)), 1e-6
    found, direction = unsupplied(w, edges, 1e-3), rng.normal(size=(6, 20))
    after, before = (unsupplied(w + sign * h * direction, edges, 1e-3).rest for sign in (1, -1))
    moved = np.einsum("sij,js->is", projection(found, edges, 1e-3), direction)
    np.testing.assert_allclose((after - before) / (2 * h), moved, atol=1e-6)


@dataclass(frozen=True, eq=False)
class Told:
    name: str
    values: Array


VALUES = st.lists(st.sampled_from([0.0, -0.0, 1.0, np.nextafter(1, 2), np.nan]), min_size=2, max_size=2).map(np.array)


def human() -> Figure:
    return figure_of(models.figure_text("human"))


def test_an_answer_is_found_once_and_the_one_that_is_requested_longest_ago_goes():
    found: list[int] = []

    def find(n: int) -> int:
        found.append(n)
        return 10 * n

    some: Cache[int] = Cache(2)
    assert [some.get(n, lambda n=n: find(n)) for n in (1, 2, 1, 3, 1, 2)] == [10, 20, 10, 30, 10, 20]
    assert found == [1, 2, 3, 2]
    assert len(some) == 2


def test_an_exception_is_no_answer():
    some: Cache[int] = Cache(2)
    with pytest.raises(ZeroDivisionError):
        some.get("a", lambda: 1 // 0)
    assert some.get("a", lambda: 7) == 7


@settings(deadline=None, max_examples=25)
@given(VALUES, VALUES, st.sampled_from("ab"), st.sampled_from("ab"))
def test_content_is_the_same_where_every_bit_is(a, b, one, other):
    are_alike = a.tobytes() == b.tobytes() and one == other
    assert (cache_key(Told(one, a)) == cache_key(Told(other, b))) == are_alike
    assert (cache_key([one, (a,)]) == cache_key([other, (b,)])) == are_alike
    assert hash(cache_key([Told(one, a), None, 1.5])) == hash(cache_key([Told(one, a.copy()), None, 1.5]))


def test_content_tells_kinds_and_shapes_apart():
    values = np.arange(4.0)
    assert cache_key(values) != cache_key(values.reshape(2, 2))
    assert cache_key(values) != cache_key(values.astype(np.float32))
    assert cache_key((1.0, 2.0)) != cache_key([1.0, 2.0])
    place = np.zeros(3)
    assert cache_key(SiteGoal("a", place)) != cache_key(PointGoal("a", 1, place, place))


def test_a_pose_is_searched_once_for_a_figure_and_depends_on_what_its_goals_do_alone(monkeypatch):
    figure, rng = human(), np.random.default_rng(1)
    data = kinematics(figure.model)
    goals = [SiteGoal("left_hand", data.site("left_hand").xpos + np.array([0.2, 0, 0.3]))]
    home, free = np.array(figure.model.qpos0), np.ones(figure.width, bool)
    free[:7] = False
    first = posed(figure, home, free, goals)
    assert first.is_met
    other = np.array(home)
    for link in figure.links[1:]:
        columns = quaternion_columns(link)
        if columns is not None and not reached(figure, goals)[columns].any():
            other[columns] = quat.normalised(rng.normal(size=4))
    fresh = posed(human(), other, free, goals)

    def never(*_: object) -> None:
        pytest.fail("searched again")

    monkeypatch.setattr(inverse_kinematics, "_posed", never)
    again = posed(figure, other, free, goals)
    own = reached(figure, goals)
    assert np.array_equal(again.qpos, fresh.qpos)
    assert np.array_equal(again.qpos[own], first.qpos[own])
    assert np.array_equal(again.qpos[~own], other[~own])


def test_a_pose_that_anything_it_depends_on_differs_for_is_another():
    figure = human()
    data = kinematics(figure.model)
    place = data.site("left_hand").xpos + np.array([0.2, 0, 0.3])
    goals, home, free = [SiteGoal("left_hand", place)], np.array(figure.model.qpos0), np.ones(figure.width, bool)
    free[:7] = False
    first = posed(figure, home, free, goals).qpos
    assert not np.array_equal(posed(figure, home, free, [SiteGoal("left_hand", place + 1e-3)]).qpos, first)
    elbow = next(i for i, link in enumerate(figure.links) if link.name == "left_elbow")
    held = np.array(free)
    held[figure.links[elbow].columns] = False
    assert not np.array_equal(posed(figure, home, held, goals).qpos, first)
    bent = np.array(home)
    columns = quaternion_columns(figure.links[elbow])
    bent[columns] = quat.from_rotation_vector(np.array([0, -0.5, 0]))
    assert not np.array_equal(posed(figure, bent, free, goals).qpos, first)


REACH = """
[[keyframe]]
time = {}
others = "rest"
sites.left_hand = [0.2, 0.3, {}]
"""


@pytest.mark.slow
def test_an_edit_of_a_clip_keyed_by_places_searches_few_of_its_poses_and_gives_what_the_text_alone_does(monkeypatch):
    monkeypatch.setattr(load, "scene_and_figure", figures.COMPOSED)  # no other test has searched these poses
    places = "".join(REACH.format(time, height) for time, height in enumerate((1.1, 1.2, 1.4)))
    clip = recordings.from_text(f'figure = "human"\n{places}', name="reach")
    text = clip.text.replace("0.3, 1.4]", "0.3, 1.39]", 1)
    assert text != clip.text
    searched: list[int] = []
    search = inverse_kinematics._posed

    def counted(asked: PoseSearch, starts: int) -> Posed:
        searched.append(1)
        return search(asked, starts)

    monkeypatch.setattr(inverse_kinematics, "_posed", counted)
    edited = recordings.from_text(text, name="reach", like=clip)
    few, _ = len(searched), searched.clear()
    recordings.from_text(text + '[[penalty]]\nkind = "torque"\n', name="reach", like=edited)
    assert not searched
    fresh = recordings.from_text(text, name="reach")
    assert 0 < few < len(searched) / 2
    for one, other in zip(edited.keys, fresh.keys, strict=True):
        assert np.array_equal(one.state, other.state)


needs_kernel = pytest.mark.skipif(compiled.kernel is None, reason="the kernel was not built")


@needs_kernel
@pytest.mark.parametrize("name", ["run_and_step", "walk_loop"])
def test_a_model_by_the_kernel_is_numpys(name, monkeypatch):
    problem = clips.load(name).problem
    discretised = problem.objective.on(split(problem.raw, midpoints(problem.raw)))
    x = discretised.unknowns.start
    gradient = discretised(x).gradient
    models, steps = [], []
    for kernel in (compiled.kernel, None):
        monkeypatch.setattr(compiled, "kernel", kernel)
        models.append(Model(Layout(discretised), x, gradient))
        steps.append(models[-1].minimise(models[-1].scale))
    lower = models[1].layout.factor(models[1].curvature)
    assert lower is not None
    np.testing.assert_allclose(
        models[0].layout.factor(models[0].curvature), lower, rtol=1e-6, atol=1e-9 * np.abs(lower).max()
    )
    np.testing.assert_allclose(steps[0].predicted_reduction, steps[1].predicted_reduction, rtol=1e-6)
    np.testing.assert_allclose(steps[0].step, steps[1].step, rtol=0, atol=1e-5 * np.abs(steps[1].step).max())


@needs_kernel
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_weighted_squares_by_the_kernel_are_numpys(sign, rng, monkeypatch):
    problem = clips.load("walk_loop").problem
    discretised = problem.objective.on(problem.raw)
    x = discretised.unknowns.start
    model = Model(Layout(discretised), x, discretised(x).gradient)
    sampling = model.layout.sampling
    at = np.sort(rng.integers(sampling.first.size, size=40))
    rows, weight = rng.normal(size=(40, problem.figure.width)), sign * rng.uniform(0.1, 9, 40)
    matrices = []
    for kernel in (compiled.kernel, None):
        monkeypatch.setattr(compiled, "kernel", kernel)
        matrices.append(np.zeros_like(model.curvature))
        model.layout.add_rows_by_y(matrices[-1], sampling, at, rows, weight)
    np.testing.assert_allclose(matrices[0], matrices[1], rtol=0, atol=1e-12 * np.abs(matrices[0]).max())
    assert np.abs(matrices[0]).max() > 0


@needs_kernel
def test_rows_by_the_kernel_are_numpys(rng, monkeypatch):
    problem = clips.load("run_and_step").problem
    discretised = problem.objective.on(problem.raw)
    samples = discretised.evaluated_runs(discretised.unknowns.start)[0].samples
    at, link = rng.integers(samples.count, size=100), rng.integers(len(samples.figure.links), size=100)
    wrenches = Wrenches(at, link, **{vector: rng.normal(size=(3, 100)) for vector in VECTORS})
    ours = wrenches.rows(samples)
    monkeypatch.setattr(compiled, "kernel", None)
    theirs = wrenches.rows(samples)
    np.testing.assert_allclose(ours, theirs, rtol=0, atol=1e-12 * np.abs(theirs).max())


@needs_kernel
def test_it_refuses_what_does_not_fit():
    rank, first, phi = np.arange(6), np.array([0, 2]), np.ones((2, 4))
    rows, weight, at = np.ones((3, 2)), np.ones(3), np.array([0, 0, 1])
    room = np.zeros((6, 2, 5, 2))
    compiled.call("add_squares", room, rank, first, phi, at, rows, weight)
    assert room.sum() > 0
    for wrong in (
        (rank, first, phi, np.array([0, 0, 2]), rows, weight),  # a sample that there is not
        (rank, np.array([0, 3]), phi, at, rows, weight),  # coefficients past the end
        (rank[::-1] * 2, first, phi, at, rows, weight),
        (rank, first, phi, at[::-1], rows, weight),  # not rising
        (rank, first, phi[:1], at, rows, weight),
        (rank, first, phi, at, rows, weight[:2]),
    ):
        with pytest.raises(ValueError, match="do not fit"):
            compiled.call("add_squares", room, *wrong)
    with pytest.raises(ValueError, match="do not fit"):
        blocks = np.ones((2, 1, 3, 2, 3, 2))
        compiled.call("add_blocks", room, rank, first, np.ones((2, 3, 4)), np.array([[0, 2]]), blocks, 2)


def test_version_prints_the_kernel_in_use():
    code = "from dynsplines.__main__ import main; import sys; sys.argv = ['dynsplines', '--version']; main()"
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert ("the compiled kernel" in told) is (compiled.kernel is not None)
    assert ("NumPy alone" in told) is (compiled.kernel is None)


def threads() -> set[int]:
    return {library["num_threads"] for library in ThreadpoolController().select(user_api="blas").info()}


def test_linear_algebra_has_one_thread_inside_and_as_many_as_before_afterwards():
    before = threads()
    with one_thread():
        assert threads() == {1}
    assert threads() == before
    with pytest.raises(KeyError), one_thread():
        raise KeyError
    assert threads() == before


def test_where_it_has_two_it_has_two_again():
    with ThreadpoolController().select(user_api="blas").limit(limits=2):
        if threads() != {2}:
            pytest.skip("this machine's BLAS has one thread whatever it is told")
        with one_thread():
            assert threads() == {1}
        assert threads() == {2}
