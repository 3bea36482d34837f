"""Heights of points that are known badly: over what is below them, or beside them and much nearer."""

import mujoco
import numpy as np
import pytest

from dynsplines.solver.surface import Box, Plane
from dynsplines.solver.surface.heights import (
    FAR,
    clearance_gradients,
    clearances,
    ground_at,
    height_over,
    heights_nearby,
)

UP = np.array([0.0, 0, 1])
FLOOR = Plane("floor", np.zeros(3), UP)
BOX = Box("box", np.array([0.0, 0.0, 0.2]), np.eye(3), np.array([0.5, 0.5, 0.2]))
TILT = np.array([np.sin(0.4), 0, np.cos(0.4)])
REACH = 0.1


def test_within_reach_of_an_edge_it_is_the_nearer_of_both(rng):
    """Over a box and its floor: the top's where a point is over it or within 7 cm of it, in any direction; what lies
    between that and 10 cm depends on the direction."""
    points = np.vstack([rng.uniform(-0.8, 0.8, (2, 1, 400)), rng.uniform(0.0, 0.7, (1, 1, 400))])
    found, where = heights_nearby([FLOOR, BOX], points, np.array([0.05]), REACH)
    beyond = np.maximum(np.abs(points[:2]) - 0.5, 0).max(axis=0)[0]
    z = points[2, 0] - 0.05
    top_is_nearer, on_top, on_floor = np.abs(z - 0.4) + 0.05 < np.abs(z), beyond == 0, beyond > REACH
    reached = top_is_nearer & (beyond < 0.7 * REACH) & ~on_top & (z > 0.26)
    assert reached.sum() > 10
    np.testing.assert_allclose(found[0, reached], z[reached] - 0.4, atol=1e-12)
    np.testing.assert_allclose(found[0, on_floor], z[on_floor], atol=1e-12)
    high = on_top & (beyond == 0) & (np.abs(points[:2]).max(axis=0)[0] < 0.5 - REACH) & (z > 0.26)
    np.testing.assert_allclose(found[0, high], z[high] - 0.4, atol=1e-12)
    np.testing.assert_allclose(height_over([FLOOR, BOX], where, np.array([0.05]))[0], found, atol=1e-12)
    np.testing.assert_array_less(np.linalg.norm((where - points)[:, 0], axis=0), REACH + 1e-12)


@pytest.mark.parametrize(("height", "is_on_top"), [(0.07, False), (0.08, True)])
def test_the_ground_below_wins_unless_that_beside_is_nearer_by_5_cm(height, is_on_top):
    low = Box("low", np.array([0.0, 0.0, 0.05]), np.eye(3), np.array([0.5, 0.5, 0.05]))
    points = np.array([[[0.55, -0.55]], [[0.0, 0.0]], [[height + 0.05] * 2]])
    found, _ = heights_nearby([FLOOR, low], points, np.array([0.05]), REACH)
    np.testing.assert_allclose(found, height - 0.1 * is_on_top, atol=1e-12)


def test_over_a_slope_it_is_that_of_the_slope_unless_it_is_far_off():
    slope = Plane("slope", np.zeros(3), TILT)
    points = np.array([[0.0, 0.3], [0.0, 0.0], [0.06, 0.0]])[:, None]
    found, _ = heights_nearby([slope], points, np.array([0.05]), REACH)
    np.testing.assert_allclose(found, height_over([slope], points, np.array([0.05]))[0], atol=0.06)
    assert found[0, 0] == pytest.approx(0.06 * TILT[2] - 0.05)


@pytest.mark.parametrize("normal", [UP, TILT])
def test_the_ground_of_a_point_is_the_plane_below_it(normal, rng):
    plane = Plane("plane", rng.normal(size=3), normal)
    point = plane.point + 0.04 * normal + np.cross(normal, rng.normal(size=3))
    found = ground_at([plane], point, 0.03, REACH)
    assert found is not None
    np.testing.assert_allclose(found.normal, normal, atol=1e-12)
    elsewhere = rng.normal(size=(3, 5))
    np.testing.assert_allclose(found.height(elsewhere), plane.height(elsewhere), atol=1e-12)


def test_next_to_an_edge_it_is_the_plane_that_ends_there_and_where_nothing_is_there_is_none():
    found = ground_at([FLOOR, BOX], np.array([0.55, 0.1, 0.46]), 0.05, REACH)
    assert found is not None
    assert found.height(np.array([0.7, 0.0, 0.41])) == pytest.approx(0.01)
    assert ground_at([BOX], np.array([2.0, 0.0, 0.4]), 0.05, REACH) is None
    height, _ = heights_nearby([BOX], np.array([[[2.0]], [[0.0]], [[0.4]]]), np.array([0.05]), REACH)
    assert height[0, 0] == FAR


ONE_BOX = """<mujoco><worldbody><geom type="box" size=".5 .3 .2" pos=".1 .2 .2" euler="0 0 40"/>
<body mocap="true"><geom size="1e-6"/></body></worldbody></mujoco>"""


def test_clearances_are_distances_by_mujoco_for_points_above_the_top_of_a_box(rng):
    """The floor is nearer for some of the points, and the gradients are those of the values."""
    model = mujoco.MjModel.from_xml_string(ONE_BOX)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    box = Box("box", data.geom_xpos[0].copy(), data.geom_xmat[0].reshape(3, 3).copy(), model.geom_size[0].copy())
    bottoms = rng.uniform([-1, -1, 0.4], [1, 1, 0.9], (200, 3))
    expected = np.empty(len(bottoms))
    for i, place in enumerate(bottoms):
        data.mocap_pos[0] = place
        mujoco.mj_kinematics(model, data)
        expected[i] = min(mujoco.mj_geomDistance(model, data, 0, 1, 9.0, None) + 1e-6, place[2])
    points = (bottoms + 0.05 * UP).T[:, None]
    found, origin = clearances([FLOOR, box], points, np.array([0.05]))
    gradient = clearance_gradients([FLOOR, box], origin[0], points[:, 0], np.full(200, 0.05))
    np.testing.assert_allclose(found[0], expected, atol=1e-9)
    step, h = rng.normal(size=points.shape), 1e-6
    rise = [clearances([FLOOR, box], points + s * step, np.array([0.05]))[0] for s in (-h, h)]
    np.testing.assert_allclose((rise[1] - rise[0]) / (2 * h), np.einsum("is,ins->ns", gradient, step), atol=1e-4)
