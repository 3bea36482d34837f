"""The same stage draws with OpenGL, where that works, and with the CPU alone everywhere."""

import mujoco
import numpy as np
import pytest
from texts import read_data

from dynsplines.picture.camera import View, axes
from dynsplines.picture.graphics import Graphics, choose
from dynsplines.picture.raster import SHADE, SHADE_HEIGHT
from dynsplines.picture.stage import Ghost, Stage
from dynsplines.scene.assets import Scene

SCENE = read_data("lights.xml")
SHAPES = read_data("shapes.xml")
SIDE = View((0.0, 0.0, 1.0), 5.0, 90.0, -15.0)
HERE = np.array([0, 0, 1, 1, 0, 0, 0.0])
SOFTWARE = Graphics("software", "renderer: software")


@pytest.fixture(scope="module")
def gl() -> Graphics:
    """OpenGL, where it works."""
    found = choose()
    if found.kind == "software":
        pytest.skip("no OpenGL here")
    return found


@pytest.fixture(params=["software", "gl"])
def graphics(request: pytest.FixtureRequest) -> Graphics:
    return SOFTWARE if request.param == "software" else request.getfixturevalue("gl")


def drawn(
    mjcf: str, qpos, view: View = SIDE, ghosts=(), size: tuple[int, int] = (96, 64), graphics: Graphics = SOFTWARE
) -> np.ndarray:
    with Stage(Scene(mjcf), size[0], size[1], graphics) as stage:
        return stage.picture(qpos, view, ghosts=ghosts).astype(int)


def moved(x: float, y: float = 0.0, z: float = 0.0) -> np.ndarray:
    """(7,) the state of the sphere moved from its place [m]."""
    return HERE + np.array([x, y, z, 0, 0, 0, 0])


def redness(image: np.ndarray) -> np.ndarray:
    """(H, W) how much redder than grey."""
    return image[..., 0] - image[..., 1]


def test_every_pixel_shows_the_geom_that_mujocos_rays_meet_there_and_the_height_of_the_figure_above():
    """Each geom has its colour under ambient light alone; the floor below the figure is darker."""
    size, view = (144, 96), View((0.0, 0.2, 0.5), 4.0, 100.0, -25.0)
    qpos = np.array([0.1, 0.2, 0.5, 0.9, 0.1, -0.3, 0.2])
    image = drawn(SHAPES, qpos, view, size=size)
    model = Scene(SHAPES).model()
    data = mujoco.MjData(model)
    data.qpos[:] = qpos
    mujoco.mj_forward(model, data)
    basis, (x, y) = axes(view.azimuth, view.elevation), np.meshgrid(*(np.arange(n) + 0.5 for n in size))
    eye = np.asarray(view.lookat) - view.distance * basis[2]
    focus = size[1] / 2 / np.tan(np.radians(model.vis.global_.fovy / 2))
    across, down = (x - size[0] / 2) / focus, (y - size[1] / 2) / focus
    rays = np.stack([across, -down, np.ones_like(across)], axis=-1) @ basis
    rays /= np.linalg.norm(rays, axis=-1, keepdims=True)
    groups, met = np.array([1, 1, 1, 0, 0, 0], np.uint8), np.zeros((1, 1), np.int32)

    def cast(start, ray, scene: int = 1) -> tuple[float, int]:
        distance = mujoco.mj_ray(model, data, start, ray, groups, scene, -1, met)
        return distance, int(met[0, 0]) if distance >= 0 else -1

    hits = [cast(eye, ray) for ray in rays.reshape(-1, 3)]
    distance, geom = (np.array(part).reshape(size[::-1]) for part in zip(*hits, strict=True))
    inner = (geom >= 0) & (distance < 6)  # before the haze; with neighbours of the same geom
    for step in (1, -1):
        for axis in (0, 1):
            inner &= geom == np.roll(geom, step, axis)
    inner[[0, -1]] = inner[:, [0, -1]] = False
    assert set(geom[inner]) == {0, 1, 2, 3, 6, 7, 8, 9}
    found = image[inner] / image[inner].max(axis=-1, keepdims=True)
    colour = model.geom_rgba[geom[inner], :3]
    assert (np.abs(found - colour / colour.max(axis=-1, keepdims=True)).max(axis=-1) < 0.15).mean() > 0.995
    row, column = np.nonzero(inner & (geom == 0))
    starts = eye + distance[row, column, None] * rays[row, column]
    height = np.array([cast(start, np.array([0.0, 0, 1]), scene=0)[0] for start in starts])
    shade = np.where(height >= 0, SHADE * np.exp(-height / SHADE_HEIGHT), 0)
    is_right, is_shaded = np.abs(image[row, column, 0] / 255 - (1 - shade)) < 0.03, shade > 0.05
    assert np.count_nonzero(is_shaded) > 100
    assert is_right.mean() > 0.98
    assert is_right[is_shaded].mean() > 0.9


def test_a_checker_has_its_colours_near_and_their_mean_far_away():
    scene = read_data("checker.xml")
    near = drawn(scene, None, View((0.0, 0.0, 0.0), 3.0, 90.0, -89.0))
    assert near[..., 0].max() > 230
    assert near[..., 2].max() > 230
    assert np.ptp(drawn(scene, None, View((0.0, 0.0, 0.0), 400.0, 90.0, -89.0))[..., 0]) < 12


def test_edges_are_smooth_and_a_floor_ends_in_haze_below_a_bluish_sky():
    image, red = drawn(SCENE, None), redness(drawn(SCENE, HERE))
    assert ((red > 15) & (red < 0.5 * red.max())).any()
    assert image[0, :, 2].mean() > image[0, :, 0].mean()
    assert np.ptp(image[-1].mean(axis=0)) < 5


def test_a_figure_that_surrounds_the_camera_does_no_harm():
    assert drawn(SCENE, HERE, View((0.0, 0.0, 1.0), 0.1, 90.0, 0.0)).shape == (64, 96, 3)


@pytest.mark.slow
def test_ghosts_are_drawn_next_to_the_main_figure_in_their_shade():
    row = drawn(SCENE, HERE, ghosts=[Ghost(moved(x), 0.7) for x in (-1.2, 1.2)])[26:34].mean(axis=0)
    ghost, main = row[24:30].mean(axis=0), row[45:51].mean(axis=0)
    assert main[0] - main[1] > 1.5 * (ghost[0] - ghost[1]) > 15
    assert redness(drawn(SCENE, None)).max() < 30


@pytest.mark.slow
def test_a_translucent_ghost_is_halfway_between_there_and_not_there(graphics: Graphics):
    bare, half, full = (
        drawn(SCENE, None, ghosts=ghosts, graphics=graphics)[30, 48]
        for ghosts in ([Ghost(HERE, 0, 0.0)], [Ghost(HERE, 0, 0.5)], [Ghost(HERE)])
    )
    assert full[0] - full[1] > 40
    np.testing.assert_allclose(half, (bare + full) / 2, atol=3)


def test_ghosts_are_hidden_by_what_is_nearer_in_either_order():
    near, far, faint = Ghost(moved(0, -1.0)), Ghost(moved(0, 1.0), 0.9), Ghost(moved(0, 1.0), 0.9, 0.5)
    one, other, alone, both = (drawn(SCENE, None, ghosts=g) for g in ([near, far], [far, near], [near], [near, faint]))
    assert (one == other).all()
    assert redness(one)[26:36, 44:52].max() > 60
    assert np.abs(alone - both)[32, 48].max() <= 1


@pytest.mark.slow
def test_a_camera_of_the_model_can_be_looked_through(graphics: Graphics):
    with Stage(Scene(SCENE), 96, 64, graphics) as stage:
        image = stage.picture(HERE, View((0.0, 0.0, 0.0), 1.0, 0.0, 0.0, fixed="high")).astype(int)
    np.testing.assert_allclose(np.argwhere(redness(image) > 40).mean(axis=0), [31.5, 47.5], atol=2)


@pytest.mark.slow
def test_both_renderers_agree_about_where_things_are_also_in_large_pictures(gl: Graphics):
    one, other = (redness(drawn(SCENE, moved(0.7, 0.3, 0.2), size=(700, 500), graphics=g)) > 40 for g in (gl, SOFTWARE))
    assert one.shape == (500, 700)
    assert (one != other).sum() < 0.05 * one.sum()


@pytest.mark.slow
def test_shadows_follow_the_camera(gl: Graphics):
    view = View((60.0, 0.0, 0.0), 6.0, 90.0, -60.0)
    bare, shaded = (drawn(SCENE, q, view, graphics=gl) for q in (None, moved(60)))
    assert ((bare - shaded).min(axis=-1) > 30).sum() > 20
    plain = SCENE.replace('directional="true"', 'directional="true" castshadow="false"')
    bare, shaded = (drawn(plain, q, view, graphics=gl) for q in (None, moved(60)))
    assert np.abs(bare - shaded)[redness(shaded) < 5].max() < 25


OLD = pytest.mark.skipif(not hasattr(mujoco, "mjtLightType"), reason="this MuJoCo has no lamps that shine all round")


@pytest.mark.parametrize(
    "kind", ["directional='true'", pytest.param("type='point' pos='0 0 4'", marks=OLD), "pos='0 0 4'"]
)
def test_every_kind_of_lamp_lights_the_floor(kind: str):
    lamp = f"<light {kind} dir='0 0 -1' diffuse='.5 .5 .5'/>"
    scene = "<mujoco><worldbody>{}<geom type='plane' size='0 0 1' rgba='.5 .5 .5 1'/></worldbody></mujoco>"
    view = View((0.0, 0.0, 0.0), 3.0, 90.0, -60.0)
    dark, lit = (drawn(scene.format(text), None, view)[32, 48] for text in ("", lamp))
    assert (lit - dark).min() > 20
