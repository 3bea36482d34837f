"""The same stage draws with OpenGL, where that works, and with rays everywhere."""

import numpy as np
import pytest

from dynsplines.picture.camera import View
from dynsplines.picture.ghost import Ghost
from dynsplines.picture.graphics import Graphics, choose
from dynsplines.picture.stage import Stage, _simplify
from dynsplines.scene.assets import Scene

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
SIDE = View((0.0, 0.0, 1.0), 5.0, 90.0, -15.0)
HERE = np.array([0, 0, 1, 1, 0, 0, 0.0])
RAYS = Graphics("rays", "renderer: rays")


@pytest.fixture(scope="module")
def gl() -> Graphics:
    """OpenGL, where it works."""
    found = choose()
    if found.kind == "rays":
        pytest.skip("no OpenGL here")
    return found


@pytest.fixture(params=["rays", "gl"])
def graphics(request: pytest.FixtureRequest) -> Graphics:
    return RAYS if request.param == "rays" else request.getfixturevalue("gl")


def moved(x: float, y: float = 0.0, z: float = 0.0) -> np.ndarray:
    """(7,) the state of the sphere moved from its place [m]."""
    return HERE + np.array([x, y, z, 0, 0, 0, 0])


def redness(image: np.ndarray) -> np.ndarray:
    return image[..., 0].astype(int) - image[..., 1]


@pytest.mark.slow
def test_a_picture_has_the_size_and_type_that_were_asked_for(graphics: Graphics):
    with Stage(Scene(SCENE), 96, 64, graphics) as stage:
        image = stage.picture(HERE, SIDE)
    assert image.shape == (64, 96, 3)
    assert image.dtype == np.uint8


@pytest.mark.slow
def test_a_picture_that_is_drawn_to_be_shrunk_is_the_same_when_it_is(gl: Graphics):
    shrunk = []
    for times in (1.0, 2.0):
        with Stage(Scene(SCENE), 192, 128, gl, shrunk=times) as stage:
            assert stage.model.vis.quality.offsamples == (0 if times == 2 else 4)
            picture = stage.picture(moved(0.3), SIDE).astype(float)
        shrunk.append(picture.reshape(64, 2, 96, 2, 3).mean(axis=(1, 3)))
    off = np.abs(shrunk[0] - shrunk[1]).max(axis=-1)
    assert np.percentile(off, 95) < 4
    assert off.mean() < 2


def test_what_is_shown_small_needs_less_quality():
    vis = Scene(SCENE).model().vis
    vis.quality.numslices, vis.quality.numstacks, vis.quality.shadowsize = 24, 14, 4096
    _simplify(vis, 540, 2.0)
    assert (vis.quality.numslices, vis.quality.numstacks, vis.quality.shadowsize) == (9, 6, 1024)
    _simplify(vis, 1440, 2.0)
    assert (vis.quality.numslices, vis.quality.numstacks, vis.quality.shadowsize) == (9, 6, 1024)
    whole = Scene(SCENE).model().vis
    before = (whole.quality.offsamples, whole.quality.numslices, whole.quality.shadowsize)
    _simplify(whole, 100, 1.5)
    assert (whole.quality.offsamples, whole.quality.numslices, whole.quality.shadowsize) == before


@pytest.mark.slow
def test_the_figure_stands_where_its_state_says(graphics: Graphics):
    with Stage(Scene(SCENE), 96, 64, graphics) as stage:
        left, right = (stage.picture(moved(x), SIDE) for x in (-1, 1))
    assert np.nonzero(redness(left) > 40)[1].mean() < 40
    assert np.nonzero(redness(right) > 40)[1].mean() > 56


@pytest.mark.slow
def test_a_picture_without_a_main_figure_shows_the_scene_alone(graphics: Graphics):
    with Stage(Scene(SCENE), 96, 64, graphics) as stage:
        assert redness(stage.picture(None, SIDE)).max() < 30


@pytest.mark.slow
def test_ghosts_are_drawn_beside_the_main_figure_in_their_shade(graphics: Graphics):
    ghosts = [Ghost(moved(x), 0.7) for x in (-1.2, 1.2)]
    with Stage(Scene(SCENE), 96, 64, graphics) as stage:
        image = stage.picture(HERE, SIDE, ghosts=ghosts)
    row = image[26:34].mean(axis=0)
    ghost, main = row[24:30].mean(axis=0), row[45:51].mean(axis=0)
    assert main[0] - main[1] > 1.5 * (ghost[0] - ghost[1]) > 15


@pytest.mark.slow
def test_ghosts_alone_make_a_picture(graphics: Graphics):
    with Stage(Scene(SCENE), 96, 64, graphics) as stage:
        assert redness(stage.picture(None, SIDE, ghosts=[Ghost(HERE)])).max() > 40


@pytest.mark.slow
def test_a_translucent_ghost_lets_the_background_through(graphics: Graphics):
    with Stage(Scene(SCENE), 96, 64, graphics) as stage:
        bare = stage.picture(None, SIDE)[30, 48].astype(float)
        full, half = (
            stage.picture(None, SIDE, ghosts=[Ghost(HERE, 0, alpha)])[30, 48].astype(float) for alpha in (1.0, 0.5)
        )
    np.testing.assert_allclose(half, (bare + full) / 2, atol=3)


@pytest.mark.slow
def test_a_camera_of_the_model_can_be_looked_through(graphics: Graphics):
    with Stage(Scene(SCENE), 96, 64, graphics) as stage:
        image = stage.picture(HERE, View((0.0, 0.0, 0.0), 1.0, 0.0, 0.0, fixed="high"))
        assert stage.cameras == ("high",)
    assert np.nonzero(redness(image) > 40)[1].mean() == pytest.approx(47.5, abs=2)


@pytest.mark.slow
def test_both_renderers_agree_about_where_things_are(gl: Graphics):
    pictures = []
    for graphics in (gl, RAYS):
        with Stage(Scene(SCENE), 192, 128, graphics) as stage:
            pictures.append(redness(stage.picture(moved(0.7, 0.3, 0.2), SIDE)) > 40)
    assert (pictures[0] != pictures[1]).sum() < 0.12 * pictures[0].sum()


@pytest.mark.slow
def test_a_picture_larger_than_the_model_foresees_is_drawn(gl: Graphics):
    with Stage(Scene(SCENE), 700, 500, gl) as stage:
        assert stage.picture(HERE, SIDE).shape == (500, 700, 3)


@pytest.mark.slow
def test_shadows_follow_the_camera(gl: Graphics):
    far = moved(60)
    view = View((60.0, 0.0, 0.0), 6.0, 90.0, -60.0)
    with Stage(Scene(SCENE), 96, 64, gl) as stage:
        bare, drawn = stage.picture(None, view).astype(int), stage.picture(far, view).astype(int)
    assert ((bare - drawn).min(axis=-1) > 30).sum() > 20


def test_a_state_of_the_wrong_length_is_refused():
    with Stage(Scene(SCENE), 32, 32, RAYS) as stage, pytest.raises(ValueError, match=r"this model's is \(7,\)"):
        stage.picture(np.zeros(3), SIDE)


def test_an_unknown_camera_lists_those_there_are():
    view = View((0.0, 0.0, 0.0), 1.0, 0.0, 0.0, fixed="low")
    with Stage(Scene(SCENE), 32, 32, RAYS) as stage, pytest.raises(ValueError, match=r"no camera 'low'; .*: high"):
        stage.picture(HERE, view)


@pytest.mark.parametrize(("shade", "opacity"), [(-0.1, 1.0), (1.1, 1.0), (0.0, 2.0), (float("nan"), 1.0)])
def test_shade_and_opacity_are_between_nothing_and_one(shade: float, opacity: float):
    with pytest.raises(ValueError, match="between 0 and 1"):
        Ghost(HERE, shade, opacity)
