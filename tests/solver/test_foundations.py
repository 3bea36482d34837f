"""Quaternions, cones, caches, the C kernel and threads."""

import numpy as np
import pytest
import shipped
from figures import TINY, figure_of
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import nnls
from scipy.spatial.transform import Rotation
from threadpoolctl import ThreadpoolController

from dynsplines import models
from dynsplines.solver import compiled
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.cone import projection, split_off_cone
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.inbetween import inbetween, one_thread
from dynsplines.solver.penalty import RootAcceleration
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.refine.subdivision import midpoints, split
from dynsplines.solver.search.quadratic import Layout, QuadraticModel

component = st.floats(-2, 2, allow_nan=False).map(lambda x: round(x, 6))


few = settings(deadline=None, max_examples=25)


quaternions = st.tuples(*[component] * 4).map(np.array).filter(lambda q: np.linalg.norm(q) > 0.1)


vectors = st.tuples(*[component] * 3).map(np.array)


def scipy_rotation(q: np.ndarray) -> Rotation:
    return Rotation.from_quat(np.roll(q, -1, axis=-1))


@few
@given(quaternions, quaternions, vectors)
def test_rotations_compose_and_turn_vectors_as_scipys_do(p, q, v):
    np.testing.assert_allclose(quat.rotate(q, v), scipy_rotation(q).apply(v), atol=1e-12)
    np.testing.assert_allclose(quat.matrices(q), scipy_rotation(q).as_matrix(), atol=1e-12)
    np.testing.assert_allclose(
        quat.rotate(quat.product(p, q), v), (scipy_rotation(p) * scipy_rotation(q)).apply(v), atol=1e-12
    )
    with np.errstate(invalid="ignore", divide="ignore"):
        assert np.isnan(quat.rotate(0 * q, v)).all()  # as of arrays


@few
@given(quaternions)
def test_exponential_and_logarithm_are_inverse_and_agree_with_scipy(q):
    log = quat.rotation_vector(q)
    assert np.linalg.norm(log) <= np.pi + 1e-12
    back = quat.from_rotation_vector(log)
    unit = quat.normalise(q)
    np.testing.assert_allclose(back * np.sign(back @ unit), unit, atol=1e-12)
    if np.linalg.norm(log) < 3.1:
        np.testing.assert_allclose(log, scipy_rotation(q).as_rotvec(), atol=1e-12)


@pytest.mark.parametrize("angle", [0.0, 1e-320, 1e-170, 1e-12, 1.9e-9, 2.1e-9, 1e-6, 1e-3, 3.0])
def test_small_angles_keep_their_relative_accuracy_alone_and_among_others(angle):
    v = angle * np.array([0.6, 0.0, -0.8])
    for q in (quat.from_rotation_vector(v), 30 * quat.from_rotation_vector(v)):
        np.testing.assert_allclose(quat.rotation_vector(q), v, rtol=1e-13, atol=5e-324)
        np.testing.assert_allclose(quat.rotation_vector(q[None]), v[None], rtol=1e-12, atol=1e-300)


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


@few
@given(*[vectors.filter(lambda v: np.linalg.norm(v) > 0.1)] * 2, st.booleans())
def test_a_swing_is_the_shortest_rotation_of_one_direction_to_another(start, end, opposite):
    """Of opposite directions, it is half a turn in their plane with the third direction."""
    end = -2 * start if opposite else end
    other = np.roll(start, 1) * [1, -2, 3] + [0.0, 0, 9]
    swing = quat.swing(start, end, other)
    start, end = (v / np.linalg.norm(v) for v in (start, end))
    np.testing.assert_allclose(quat.rotate(swing, start), end, atol=1e-9)
    np.testing.assert_allclose(
        np.linalg.norm(quat.rotation_vector(swing)), np.arccos(np.clip(start @ end, -1, 1)), atol=1e-7
    )
    if opposite:
        np.testing.assert_allclose(np.linalg.det([start, other, swing[1:]]), 0, atol=1e-9)


def test_an_aligned_track_has_neighbours_on_one_hemisphere_and_the_same_rotations(rng):
    track = rng.normal(size=(40, 3, 4))
    aligned = quat.align_signs(track)
    assert np.all(np.sum(aligned[1:] * aligned[:-1], axis=-1) >= 0)
    np.testing.assert_array_equal(np.abs(aligned), np.abs(track))
    np.testing.assert_array_equal(aligned[0], track[0])
    signs = aligned / track
    np.testing.assert_array_equal(signs, np.broadcast_to(signs[..., :1], signs.shape))
    assert (signs < 0).any()


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
    found = split_off_cone(w, edges, softness)
    for s in range(60):
        matrix = np.vstack([edges[:, :, s], np.sqrt(softness) * np.eye(edges.shape[1])])
        shares, size = nnls(matrix, np.append(w[:, s], np.zeros(edges.shape[1])))
        np.testing.assert_allclose(found.value[s], size**2, atol=1e-12)
        np.testing.assert_allclose(found.rest[:, s], w[:, s] - edges[:, :, s] @ shares, atol=1e-7)
        np.testing.assert_allclose(found.shares[:, s], shares, atol=1e-5)


def test_the_projection_is_how_the_rest_moves_with_the_vector(rng):
    edges, w, h = pyramids(rng, 2, 20), rng.normal(size=(6, 20)), 1e-6
    found, direction = split_off_cone(w, edges, 1e-3), rng.normal(size=(6, 20))
    after, before = (split_off_cone(w + sign * h * direction, edges, 1e-3).rest for sign in (1, -1))
    moved = np.einsum("sij,js->is", projection(found, edges, 1e-3), direction)
    np.testing.assert_allclose((after - before) / (2 * h), moved, atol=1e-6)


def human() -> Figure:
    return figure_of(models.figure_text("human"))


def test_figures_of_the_same_model_and_coordinates_are_equal():
    tiny, other = figure_of(TINY), figure_of(TINY.replace("mass=", "friction='.3' mass="))
    assert (tiny, hash(tiny)) == (figure_of(TINY), hash(figure_of(TINY)))
    assert len({tiny, figure_of(TINY), other, human(), figure_of(TINY, "joint")}) == 4


needs_kernel = pytest.mark.skipif(compiled.kernel is None, reason="the kernel was not built")


@needs_kernel
def test_a_model_by_the_kernel_is_numpys(monkeypatch):
    problem = shipped.loaded("walk_loop").problem
    discretised = problem.objective.on(split(problem.raw, midpoints(problem.raw)))
    x = discretised.unknowns.start
    gradient = discretised(x).gradient
    models, steps = [], []
    for kernel in (compiled.kernel, None):
        monkeypatch.setattr(compiled, "kernel", kernel)
        models.append(QuadraticModel(Layout(discretised), x, gradient))
        steps.append(models[-1].minimise(models[-1].scale))
    lower = models[1].layout.factor(models[1].curvature)
    assert lower is not None
    np.testing.assert_allclose(
        models[0].layout.factor(models[0].curvature), lower, rtol=1e-6, atol=1e-9 * np.abs(lower).max()
    )
    np.testing.assert_allclose(steps[0].predicted_reduction, steps[1].predicted_reduction, rtol=1e-6)
    np.testing.assert_allclose(steps[0].step, steps[1].step, rtol=0, atol=1e-5 * np.abs(steps[1].step).max())


@needs_kernel
def test_it_refuses_what_does_not_fit():
    rank, first, phi, at = np.arange(6), np.array([0, 2]), np.ones((2, 4)), np.array([0, 0, 1])
    fitting = {"rank": rank, "first": first, "phi": phi, "at": at, "rows": np.ones((3, 2)), "weight": np.ones(3)}
    room = np.zeros((6, 2, 5, 2))
    compiled.call("add_squares", room, *fitting.values())
    assert room.sum() > 0
    missing, late, falling = np.array([0, 0, 2]), np.array([0, 3]), at[::-1]
    changes = [
        ("at", missing),
        ("first", late),
        ("rank", rank[::-1] * 2),
        ("at", falling),
        ("phi", phi[:1]),
        ("weight", at[:2]),
    ]
    for name, wrong in changes:
        with pytest.raises(ValueError, match="do not fit"):
            compiled.call("add_squares", room, *{**fitting, name: wrong.astype(fitting[name].dtype)}.values())
    with pytest.raises(ValueError, match="do not fit"):
        blocks = np.ones((2, 1, 3, 2, 3, 2))
        compiled.call("add_blocks", room, rank, first, np.ones((2, 3, 4)), np.array([[0, 2]]), blocks, 2)


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


def test_a_search_in_a_program_of_the_user_has_one_thread_and_gives_the_others_back() -> None:
    seen: list[set[int]] = []
    figure = figure_of(TINY)
    keys = [Frame.key(time, figure.model.qpos0 + time * np.eye(11)[0]) for time in (0.0, 1.0, 1.5)]
    problem = Problem(figure, keys, [(RootAcceleration(), 1.0)], Settings(max_evaluations=3))
    with ThreadpoolController().limit(limits=2, user_api="blas"):
        before = threads()
        inbetween(problem, improved=lambda _: seen.append(threads()))
        after = threads()
    assert before == after == {2}
    assert seen and all(counts == {1} for counts in seen)
