"""What just touches a surface is not in it: no depth and no gradient; a last digit nearer, both are there. What is
right over the edge of one is over it, and a last digit beside it is not."""

from __future__ import annotations

import numpy as np
import pytest

from dynsplines.solver.surface import Box, Capsule, Cylinder, HeightField, Hull, Plane, Sphere, Surface, hull_of
from dynsplines.solver.surface.heights import DEEP, FAR, heights

RADIUS, DIGIT = 1.25, 2.0**-50  # the last of what the sums of radius and size can tell
CUBE = np.array([[x, y, z] for x in (-1.0, 1) for y in (-1.0, 1) for z in (-1.0, 1)])
CORNERS = hull_of(CUBE)
assert CORNERS is not None
ROUND = np.array([2.25, 0, 0]), np.array([-1.0, 0, 0])
RIM = np.array([1.75, 0, 2]), np.array([-0.6, 0, -0.8])  # 3 : 4 : 5 from an edge at x = z = 1
TOUCHES: dict[str, tuple[Surface, np.ndarray, np.ndarray]] = {
    # where a sphere touches, and which way it goes deeper; every number is exact in binary
    "plane": (Plane("p", np.zeros(3), np.array([0.0, 0, 1])), np.array([0, 0, 1.25]), np.array([0, 0, -1.0])),
    "box": (Box("b", np.zeros(3), np.eye(3), np.ones(3), sideways=1.0), np.array([0, 0, 2.25]), np.array([0, 0, -1.0])),
    "sphere": (Sphere("s", np.zeros(3), 1.0), *ROUND),
    "capsule": (Capsule("c", np.zeros(3), np.array([0.0, 0, 1]), 1.0, 1.0), *ROUND),
    "cylinder": (Cylinder("y", np.zeros(3), np.array([0.0, 0, 1]), 1.0, 1.0), *RIM),
    "hull": (Hull("h", *CORNERS), *RIM),
    "height field": (HeightField("f", np.array([0, 0, 1.0]), np.eye(3), np.ones(2), np.zeros((3, 3))), *RIM),
}


@pytest.mark.parametrize("name", TOUCHES)
def test_what_just_touches_is_not_in_it_and_what_is_any_nearer_is(name):
    surface, centre, way = TOUCHES[name]
    where = centre.reshape(3, 1, 1)
    depth, gradient = surface.depth(where, np.array([RADIUS]))
    assert not depth.any() and not gradient.any()
    depth, gradient = surface.depth(where, np.array([RADIUS + DIGIT]))
    assert 0 < depth[0, 0] < 1e-15
    np.testing.assert_allclose(gradient[:, 0, 0], way, atol=1e-12)
    if name != "height field":  # which tells a bound alone
        for radius, near in ((RADIUS, False), (RADIUS + DIGIT, True)):
            assert surface.near(where, np.array([radius])).all() == near


EDGE = 1.0 + DIGIT
OVER: dict[str, tuple[Surface, tuple[float, float], tuple[float, float], float]] = {
    # two places over its edge, and how high it is there; every number is exact in binary
    "box": (Box("b", np.zeros(3), np.eye(3), np.ones(3)), (1.0, -0.5), (0.25, 1.0), 1.0),
    "sunk box": (Box("b", np.zeros(3), np.eye(3), np.ones(3), buried=True), (-1.0, 0.5), (0.25, -1.0), 1.0),
    "hull": (Hull("h", *CORNERS), (1.0, -0.5), (0.25, -1.0), 1.0),
    "upright cylinder": (Cylinder("y", np.zeros(3), np.array([0.0, 0, 1]), 1.0, 1.0), (1.0, 0.0), (0.0, -1.0), 1.0),
    "height field": (
        HeightField("f", np.array([0, 0, 1.0]), np.eye(3), np.ones(2), np.zeros((3, 3))), (1.0, 0.5), (-0.5, -1.0), 1.0,
    ),
    "upright capsule": (Capsule("c", np.zeros(3), np.array([0.0, 0, 1]), 1.0, 1.0), (1.0, 0.0), (0.0, -1.0), 1.0),
    "sphere": (Sphere("s", np.zeros(3), 1.0), (1.0, 0.0), (0.0, -1.0), 0.0),
}  # fmt: skip


@pytest.mark.parametrize("name", OVER)
def test_over_the_edge_of_a_surface_is_over_it_and_a_last_digit_farther_out_is_not(name):
    surface, *places, top = OVER[name]
    for place in places:
        x, y = place
        at = np.array([[[x]], [[y]], [[3.0]]])
        np.testing.assert_allclose(surface.height(at), 3.0 - top, atol=1e-12)
        beside = at.copy()
        axis = int(np.argmax(np.abs(place)))
        beside[axis] *= EDGE
        assert np.isinf(surface.height(beside)).all()


@pytest.mark.parametrize("buried", [False, True])
def test_in_a_box_one_is_below_its_top_as_far_as_its_bottom_and_in_one_that_is_buried_however_deep(buried):
    box = Box("b", np.array([0.0, 0, 3]), np.diag([1.0, -1.0, -1.0]), np.array([0.5, 0.75, 0.25]), buried=buried)
    for z, over in ((3.5, True), (2.75 + DIGIT * 2, True), (2.75, buried), (2.0, buried)):
        found = box.height(np.array([[[0.5]], [[-0.75]], [[z]]])).item()
        assert found == (z - 3.25 if over else np.inf)


def test_along_a_lying_bar_one_is_over_it_up_to_its_ends_and_across_it_up_to_its_radius():
    for bar, end in (
        (Cylinder("y", np.zeros(3), np.array([1.0, 0, 0]), 1.0, 0.5), (1.0, 0.5)),
        (Capsule("c", np.zeros(3), np.array([1.0, 0, 0]), 1.0, 0.5), (1.5, 0.0)),
    ):
        for x, y, high in ((0.0, 0.0, 0.5), (1.0, 0.0, 0.5), (-1.0, 0.0, 0.5), (0.5, 0.5, 0.0), (0.5, -0.5, 0.0)):
            np.testing.assert_allclose(bar.height(np.array([[[x]], [[y]], [[3.0]]])), 3 - high, atol=1e-7)
        assert np.isfinite(bar.height(np.array([[[end[0]]], [[0.0]], [[3.0]]]))).all()
        assert np.isinf(bar.height(np.array([[[end[0] + 1e-9]], [[0.0]], [[3.0]]]))).all()
        assert np.isinf(bar.height(np.array([[[0.5]], [[0.5 + 1e-9]], [[3.0]]]))).all()


def test_of_two_surfaces_as_high_as_each_other_the_first_is_the_nearest_and_deep_below_is_neither():
    floors = [Plane(name, np.zeros(3), np.array([0.0, 0, 1])) for name in ("one", "other")]
    for z, height, nearest in ((0.5, 0.25, 0), (0.25 - DEEP, -DEEP, 0), (0.25 - DEEP - DIGIT, FAR, -1)):
        found, which = heights(floors, np.array([[[0.0]], [[0.0]], [[z]]]), np.array([0.25]))
        assert (found.item(), which.item()) == (height, nearest)
