"""What just touches a surface is not in it: no depth and no gradient; a last digit nearer, both are there."""

from __future__ import annotations

import numpy as np
import pytest

from dynsplines.solver.surface import Box, Capsule, Cylinder, HeightField, Hull, Plane, Sphere, Surface, hull_of

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
