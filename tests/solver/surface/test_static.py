"""What a model's geoms become: which stand on the floor and are buried in it, by bounds; hulls that look outward."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from dynsplines.solver.surface import Box, Cylinder, HeightField, Hull, Plane, Surface, static_surfaces
from dynsplines.solver.surface.static import DOWN, LEVEL
from dynsplines.solver.surface.surface import GROUNDED, UPRIGHT

HAIR = 1e-5
WEDGE = "0 0 0  1 0 0  0 1 0  0 0 1"


def surfaces(*geoms: str, assets: str = "", floor: str = '<geom name="floor" type="plane" size="9 9 1"/>') -> dict:
    text = f"<mujoco><asset>{assets}</asset><worldbody>{floor}{''.join(geoms)}</worldbody></mujoco>"
    return {surface.name: surface for surface in static_surfaces(mujoco.MjModel.from_xml_string(text))}


def of(geom: str, **told: str) -> Surface:
    return surfaces(geom.replace("<geom", '<geom name="it"'), **told)["it"]


@pytest.mark.parametrize(("over", "buried"), [(GROUNDED - HAIR, True), (GROUNDED + HAIR, False), (-3.0, True)])
def test_a_box_is_buried_whose_lowest_corner_is_on_the_floor_or_below_and_so_is_a_mesh(over, buried):
    box = of(f'<geom type="box" size=".3 .2 .1" pos="0 0 {over + 0.1}"/>')
    assert isinstance(box, Box) and box.buried == buried
    turned = of(f'<geom type="box" size=".3 .4 .1" pos="0 0 {over + 0.5}" zaxis="0 .6 .8" />')
    lowest = 0.5 - np.abs(turned.axes[2]) @ [0.3, 0.4, 0.1]  # type: ignore[attr-defined]
    level = of(f'<geom type="box" size=".3 .4 .1" pos="0 0 {over + 0.5 - lowest}" zaxis="0 .6 .8" />')
    assert isinstance(level, Box) and level.buried == buried
    assets = '<mesh name="m" vertex="0 0 -1 1 0 0 0 1 0 -1 -1 0"/>'
    mesh = of(f'<geom type="mesh" mesh="m" pos="0 0 {over + 1}"/>', assets=assets)
    lift = mesh.corners[2].min() - over  # type: ignore[attr-defined]
    mesh = of(f'<geom type="mesh" mesh="m" pos="0 0 {over + 1 - lift}"/>', assets=assets)
    assert isinstance(mesh, Hull) and mesh.buried == buried


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(("over", "stands"), [(GROUNDED - HAIR, True), (GROUNDED + HAIR, False), (-1.0, True)])
def test_a_cylinder_that_stands_on_the_floor_continues_below_it(over, stands, sign):
    found = of(f'<geom type="cylinder" size=".2 .5" pos="1 2 {over + 0.5}" zaxis="0 0 {sign}"/>')
    assert isinstance(found, Cylinder)
    top = found.centre + found.half * found.axis * (1 if stands else sign)
    np.testing.assert_allclose(top, [1, 2, over + 1], atol=1e-9)
    assert found.half == pytest.approx(0.5 + DOWN / 2 * stands)
    assert found.radius == 0.2


@pytest.mark.parametrize(("rise", "stands"), [(UPRIGHT + HAIR, True), (UPRIGHT - HAIR, False)])
def test_a_cylinder_that_leans_stands_as_long_as_its_end_looks_up_more_than_sideways(rise, stands):
    lean = np.sqrt(1 - rise**2)
    deep = 0.5 * rise + 0.2 * lean  # from its middle down to its rim
    for over, reaches in ((GROUNDED - 1e-4, True), (GROUNDED + 1e-4, False)):
        found = of(f'<geom type="cylinder" size=".2 .5" pos="0 0 {deep + over}" zaxis="{lean} 0 {rise}"/>')
        assert isinstance(found, Cylinder)
        assert (found.half > 1) == (stands and reaches)


def test_the_floor_is_the_highest_of_the_planes_that_are_level():
    tilt = np.sqrt(1 - (LEVEL - 1e-4) ** 2)
    floor = (
        '<geom type="plane" size="9 9 1" pos="0 0 -2"/><geom type="plane" size="9 9 1" pos="0 0 1"/>'
        f'<geom type="plane" size="9 9 1" pos="0 0 5" zaxis="{tilt} 0 {LEVEL - 1e-4}"/>'
    )
    for z, buried in ((1.1, True), (1.2, False)):
        box = of(f'<geom type="box" size=".1 .1 .1" pos="0 0 {z}"/>', floor=floor)
        assert isinstance(box, Box) and box.buried == buried
    bare = of('<geom type="box" size=".1 .1 .1" pos="0 0 -9"/>', floor="")
    assert isinstance(bare, Box) and not bare.buried


def test_planes_come_first_as_mujoco_has_them():
    found = surfaces(
        '<geom name="ball" size=".1" pos="0 0 1"/>',
        '<geom name="ramp" type="plane" size="1 1 1" zaxis="0 .6 .8" pos="1 2 3"/>',
    )
    assert list(found) == ["floor", "ramp", "ball"]
    plane = found["ramp"]
    assert isinstance(plane, Plane)
    np.testing.assert_allclose(plane.point, [1, 2, 3])
    np.testing.assert_allclose(plane.normal, [0, 0.6, 0.8], atol=1e-12)


def volume(hull: Hull) -> float:
    """By the divergence theorem: positive if triangles look outward."""
    a, b, c = (hull.corners[:, hull.faces[:, k]] for k in range(3))
    return float(np.sum(a * np.cross(b, c, axis=0)) / 6)


@pytest.mark.parametrize("collides", ["", 'contype="0" conaffinity="0"'])
def test_a_mesh_becomes_its_hull_where_it_is_with_all_triangles_outward_whether_or_not_mujoco_has_made_one(collides):
    """A wedge and a point inside it; its first vertex is where the body is, turned a quarter about z."""
    found = of(
        f'<geom type="mesh" mesh="m" pos="3 0 2" euler="0 0 90" {collides}/>',
        assets=f'<mesh name="m" inertia="exact" vertex="{WEDGE} .1 .1 .1"/>',
        floor='<geom name="other" size=".1" contype="0" conaffinity="0"/>' if collides else "",
    )
    assert isinstance(found, Hull)
    assert found.corners.shape == (3, 4)
    assert found.faces.shape == (4, 3)
    assert volume(found) == pytest.approx(1 / 6, rel=1e-5)
    np.testing.assert_allclose(sorted(np.ptp(found.corners, axis=1)), [1, 1, 1], atol=1e-6)
    assert found.distance(found.corners.mean(axis=1)[:, None])[0] < 0


def test_a_height_field_is_as_high_and_as_wide_as_mujoco_has_it():
    found = of(
        '<geom type="hfield" hfield="h" pos="1 2 3"/>',
        assets='<hfield name="h" nrow="2" ncol="3" size="4 5 .6 .1" elevation="0 1 2 3 4 5"/>',
    )
    assert isinstance(found, HeightField)
    np.testing.assert_allclose(found.half, [4, 5])
    np.testing.assert_allclose(sorted(found.elevation.ravel()), 0.6 * np.arange(6) / 5, atol=1e-6)
    assert found.elevation.shape == (2, 3)
    np.testing.assert_allclose(found.centre, [1, 2, 3])


def test_a_mesh_in_a_plane_is_no_surface():
    flat = '<mesh name="m" inertia="shell" vertex="0 0 0 1 0 0 0 1 0 1 1 0" face="0 1 2 1 3 2"/>'
    assert not surfaces('<geom type="mesh" mesh="m" contype="0" conaffinity="0"/>', assets=flat, floor="")
