"""The rays draw what is there: shapes, colours, shadows, ghosts; without any GL library."""

import mujoco
import numpy as np
import pytest

from dynsplines.picture.camera import View
from dynsplines.picture.ghost import Ghost
from dynsplines.picture.rays import Rays

SCENE = """
<mujoco>
  <visual><headlight ambient=".3 .3 .3" diffuse=".3 .3 .3" specular="0 0 0"/></visual>
  <worldbody>
    <light directional="true" dir="0 0 -1" diffuse=".5 .5 .5" specular="0 0 0"/>
    <geom type="plane" size="0 0 1" rgba=".6 .6 .6 1"/>
    <camera name="high" pos="0 -.01 5" xyaxes="1 0 0 0 1 0"/>
    <body pos="0 0 1"><freejoint/><geom type="sphere" size=".4" rgba=".8 .1 .1 1"/></body>
  </worldbody>
</mujoco>
"""
SIDE = View((0.0, 0.0, 1.0), 4.0, 90.0, -15.0)
HERE = np.array([0, 0, 1, 1, 0, 0, 0.0])


def rays(mjcf: str = SCENE, width: int = 96, height: int = 64) -> Rays:
    return Rays(mujoco.MjSpec.from_string(mjcf), width, height, threads=1)


def moved(x: float = 0.0, y: float = 0.0) -> np.ndarray:
    return HERE + np.array([x, y, 0, 0, 0, 0, 0])


def redness(image: np.ndarray) -> np.ndarray:
    """(H, W) how much redder than grey."""
    return image[..., 0].astype(int) - image[..., 1]


def test_a_sphere_is_a_red_disc_of_the_right_size_in_the_middle():
    image = rays(width=120, height=120).picture([Ghost(HERE)], View((0.0, 0.0, 1.0), 4.0, 90.0, 0.0))
    rows, columns = np.nonzero(redness(image) > 40)
    assert rows.mean() == pytest.approx(59.5, abs=1)
    assert columns.mean() == pytest.approx(59.5, abs=1)
    radius = 60 / np.tan(np.radians(22.5)) * 0.4 / np.sqrt(4**2 - 0.4**2)
    assert len(rows) == pytest.approx(np.pi * radius**2, rel=0.05)


def test_the_sky_is_above_the_floor():
    image = rays().picture([], SIDE).astype(int)
    assert image[0, :, 2].mean() > image[0, :, 0].mean()
    assert np.ptp(image[-1].mean(axis=0)) < 5


def test_the_shadow_falls_straight_below_under_a_light_from_above():
    view = View((0.0, 0.0, 0.0), 6.0, 90.0, -80.0)
    bare, shaded = rays().picture([], view).astype(int), rays().picture([Ghost(moved(x=1.0))], view).astype(int)
    dark = np.argwhere((bare - shaded).min(axis=-1) > 30)
    assert len(dark) > 20
    assert dark[:, 1].mean() > 48


def test_a_light_that_casts_no_shadow_casts_none():
    plain = SCENE.replace('directional="true"', 'directional="true" castshadow="false"')
    view = View((0.0, 0.0, 0.0), 6.0, 90.0, -80.0)
    bare, drawn = (rays(plain).picture(figures, view).astype(int) for figures in ([], [Ghost(moved(x=1.0))]))
    elsewhere = redness(drawn) < 5
    assert np.abs(bare - drawn)[elsewhere].max() < 25


OLD = pytest.mark.skipif(not hasattr(mujoco, "mjtLightType"), reason="this MuJoCo has no lamps that shine all round")


@pytest.mark.parametrize(
    "kind", ["directional='true'", pytest.param("type='point' pos='0 0 4'", marks=OLD), "pos='0 0 4'"]
)
def test_every_kind_of_lamp_lights_the_floor(kind: str):
    lamp = f"<light {kind} dir='0 0 -1' diffuse='.5 .5 .5'/>"
    scene = "<mujoco><worldbody>{}<geom type='plane' size='0 0 1' rgba='.5 .5 .5 1'/></worldbody></mujoco>"
    view = View((0.0, 0.0, 0.0), 3.0, 90.0, -60.0)
    dark, lit = (rays(scene.format(text)).picture([], view).astype(int)[32, 48] for text in ("", lamp))
    assert (lit - dark).min() > 20


@pytest.mark.parametrize(
    "geom",
    [
        "type='sphere' size='.4'",
        "type='capsule' size='.2 .3'",
        "type='cylinder' size='.3 .3'",
        "type='ellipsoid' size='.4 .3 .2'",
        "type='box' size='.3 .3 .3'",
        "type='mesh' mesh='wedge'",
    ],
)
def test_every_kind_of_geom_is_drawn(geom: str):
    mesh = "<asset><mesh name='wedge' vertex='0 0 0 .6 0 0 0 .6 0 0 0 .6'/></asset>"
    body = f"<body pos='0 0 1'><freejoint/><geom {geom} rgba='.8 .1 .1 1'/></body>"
    image = rays(f"<mujoco>{mesh}<worldbody>{body}</worldbody></mujoco>").picture([Ghost(HERE)], SIDE)
    assert (redness(image) > 20).sum() > 50


def test_a_checker_has_its_colours_near_and_their_mean_far_away():
    scene = """
    <mujoco>
      <asset>
        <texture name="t" type="2d" builtin="checker" rgb1="1 0 0" rgb2="0 0 1" width="64" height="64"/>
        <material name="m" texture="t" texrepeat="1 1" texuniform="true" specular="0"/>
      </asset>
      <visual><headlight ambient="1 1 1" diffuse="0 0 0"/></visual>
      <worldbody><geom type="plane" size="0 0 1" material="m"/></worldbody>
    </mujoco>"""
    near = rays(scene).picture([], View((0.0, 0.0, 0.0), 3.0, 90.0, -89.0)).astype(int)
    assert near[..., 0].max() > 230
    assert near[..., 2].max() > 230
    far = rays(scene).picture([], View((0.0, 0.0, 0.0), 400.0, 90.0, -89.0)).astype(int)
    assert np.ptp(far[..., 0]) < 12


def test_edges_are_smooth():
    image = rays().picture([Ghost(HERE)], SIDE)
    red = redness(image)
    assert ((red > 15) & (red < 0.5 * red.max())).any()


def test_the_model_s_own_camera_is_looked_through():
    image = rays().picture([Ghost(HERE)], View((0.0, 0.0, 0.0), 1.0, 0.0, 0.0, fixed="high"))
    rows, columns = np.nonzero(redness(image) > 40)
    assert rows.mean() == pytest.approx(31.5, abs=2)
    assert columns.mean() == pytest.approx(47.5, abs=2)


def test_a_ghost_is_paler_the_nearer_its_shade_is_to_white():
    own, pale = (rays().picture([Ghost(HERE, shade)], SIDE)[28, 48].astype(int) for shade in (0.0, 0.7))
    assert pale[1] > own[1] + 50
    assert pale[2] > own[2] + 50


def test_a_ghost_of_half_opacity_is_halfway_between_there_and_not_there():
    bare, half, full = (
        rays().picture(figures, SIDE)[28, 48].astype(float)
        for figures in ([], [Ghost(HERE, 0, 0.5)], [Ghost(HERE, 0, 1.0)])
    )
    np.testing.assert_allclose(half, (bare + full) / 2, atol=2)


def test_an_invisible_ghost_is_not_there():
    assert (rays().picture([Ghost(HERE, 0, 0.0)], SIDE) == rays().picture([], SIDE)).all()


def test_what_is_nearer_hides_what_is_farther_in_either_order():
    near, far = Ghost(moved(y=-1.0)), Ghost(moved(y=1.0), 0.9)
    one, other = rays().picture([near, far], SIDE), rays().picture([far, near], SIDE)
    assert (one == other).all()
    assert redness(one)[26:36, 44:52].max() > 60


def test_a_translucent_ghost_behind_a_solid_figure_does_not_show():
    near, far = Ghost(moved(y=-1.0)), Ghost(moved(y=1.0), 0.9, 0.5)
    alone, both = (rays().picture(figures, SIDE)[32, 48].astype(int) for figures in ([near], [near, far]))
    assert np.abs(alone - both).max() <= 1


def test_translucent_ghosts_are_blended_from_back_to_front_in_either_order():
    near, far = Ghost(moved(y=-1.0), 0, 0.5), Ghost(moved(y=1.0), 0.9, 0.5)
    one, other = rays().picture([near, far], SIDE), rays().picture([far, near], SIDE)
    assert np.abs(one.astype(int) - other).max() <= 1


def test_a_figure_that_surrounds_the_camera_does_no_harm():
    assert rays().picture([Ghost(HERE)], View((0.0, 0.0, 1.0), 0.1, 90.0, 0.0)).shape == (64, 96, 3)


def test_more_threads_draw_the_same_picture():
    spec = mujoco.MjSpec.from_string(SCENE)
    one, two = (Rays(spec, 320, 200, threads=count).picture([Ghost(HERE)], SIDE) for count in (1, 2))
    assert (one == two).all()


def test_a_scene_is_drawn_though_much_refers_to_the_figure():
    scene = """
    <mujoco>
      <worldbody>
        <body name="wall" pos="0 2 .5">
          <geom type="box" size=".5 .1 .5" rgba=".1 .7 .1 1"/>
          <body name="ball">
            <joint name="hinge"/><geom size=".3" pos="0 -2 .5" rgba=".8 .1 .1 1"/><site name="s"/>
          </body>
        </body>
        <geom type="plane" size="0 0 1" rgba=".6 .6 .6 1"/>
      </worldbody>
      <contact><exclude body1="wall" body2="ball"/></contact>
      <equality><joint joint1="hinge"/></equality>
      <tendon><fixed name="t"><joint joint="hinge" coef="1"/></fixed></tendon>
      <actuator><motor joint="hinge"/><motor tendon="t"/></actuator>
      <sensor><jointpos joint="hinge"/><framepos objtype="site" objname="s"/></sensor>
      <keyframe><key qpos="1"/></keyframe>
    </mujoco>"""
    image = rays(scene).picture([Ghost(np.zeros(1))], SIDE).astype(int)
    assert redness(image).max() > 40
    assert (image[..., 1] - image[..., 0]).max() > 40
