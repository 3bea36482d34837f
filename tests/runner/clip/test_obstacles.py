"""Obstacles of a clip's scene: where they are, how large, and what is wrong with those that are refused."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
from oracles import kinematics
from tiny import CLIP, FIGURE, written

from dynsplines.clip import load as clip
from dynsplines.errors import UserError
from dynsplines.scene.compose import compose
from dynsplines.solver.surface import Box, Capsule, Cylinder, Hull, Plane, Sphere, static_surfaces

SCENE = """
[[scene.box]]
name = "table"
position = [1, 0, 0.75]
size = [1.2, 0.8, 0.04]
rotation = {rotvec = [0, 0, 90]}
color = [0.2, 0.4, 0.6, 0.5]
[[scene.box]]
position = [3, 0, 0.5]
size = [1, 1, 1]
[[scene.sphere]]
name = "ball"
position = [2, 1, 0.2]
radius = 0.2
[[scene.capsule]]
name = "rail"
from = [0, 1, 1]
to = [2, 1, 1.5]
radius = 0.03
[[scene.cylinder]]
name = "post"
position = [0, 2, 0.5]
length = 1.0
radius = 0.05
rotation = {euler = [90, 0, 0]}
"""


def loaded(folder, scene: str) -> clip.Clip:
    return clip.load(str(written(folder, CLIP + scene)))


def geom(problem: clip.Clip, name: str) -> tuple[mujoco.MjModel, np.ndarray, np.ndarray]:
    """The model compiled from the clip's MJCF text, and a geom's place and axes."""
    model = mujoco.MjModel.from_xml_string(problem.mjcf)
    data = kinematics(model)
    return model, data.geom(name).xpos, data.geom(name).xmat.reshape(3, 3)


def test_obstacles_are_where_the_clip_specifies_and_as_large(tmp_path):
    problem = loaded(tmp_path, SCENE)
    model, place, axes = geom(problem, "table")
    np.testing.assert_allclose(place, [1, 0, 0.75])
    np.testing.assert_allclose(model.geom("table").size, [0.6, 0.4, 0.02])
    np.testing.assert_allclose(axes[:, 0], [0, 1, 0], atol=1e-12)
    np.testing.assert_allclose(model.geom("table").rgba, [0.2, 0.4, 0.6, 0.5], atol=1e-6)
    assert model.geom("box 2").matid[0] == model.material("stage_step").id
    np.testing.assert_allclose(model.geom("ball").size[0], 0.2)
    _, place, axes = geom(problem, "rail")
    np.testing.assert_allclose(place, [1, 1, 1.25], atol=1e-6)
    np.testing.assert_allclose(model.geom("rail").size[:2], [0.03, np.hypot(2, 0.5) / 2], atol=1e-5)
    np.testing.assert_allclose(np.abs(axes[:, 2] @ [2, 0, 0.5]), np.hypot(2, 0.5), atol=1e-6)
    _, _, axes = geom(problem, "post")
    np.testing.assert_allclose(np.abs(axes[:, 2]), [0, 1, 0], atol=1e-6)
    np.testing.assert_allclose(model.geom("post").size[:2], [0.05, 0.5], atol=1e-6)
    kinds = {surface.name: type(surface) for surface in problem.context.surfaces}
    assert kinds == {
        "floor": Plane, "table": Box, "box 2": Box, "ball": Sphere, "rail": Capsule, "post": Cylinder,
    }  # fmt: skip
    assert not any(model.geom(name).contype[0] for name in kinds)


@pytest.mark.parametrize(
    ("scene", "words"),
    [
        ("[[scene.box]]\nname='t'\nsize=[1,1,1]", r"scene.box 1 \('t'\): 'position' is missing"),
        ("[[scene.box]]\nposition=[0,0,0]\n", r"scene.box 1: 'size' is missing"),
        ("[[scene.box]]\nposition=[0,0,0]\nsize=[1,0,1]", r"scene.box 1: size must be above 0, not 0"),
        ("[[scene.box]]\nposition=[0,0,'free']\nsize=[1,1,1]", r"scene.box 1: position must be \[x, y, z\] in metres"),
        ("[[scene.sphere]]\nposition=[0,0,0]\nradius=-1", r"scene.sphere 1: radius must be above 0, not -1"),
        ("[[scene.sphere]]\nname='floor'\nposition=[0,0,0]\nradius=1", "model already has a geom of that name"),
        ("[[scene.ball]]\nposition=[0,0,0]\nradius=1", r"no key 'ball'.*Keys: step, box, sphere, capsule, cylinder"),
        (
            "[scene.sphere]\nposition=[0,0,0]\nradius=1",
            r"scene.sphere must be \[\[scene.sphere\]\] tables, not a table",
        ),
        ("[[scene.capsule]]\nradius=1\nfrom=[0,0,0]", "'from' and 'to' go together"),
        ("[[scene.capsule]]\nradius=1\nposition=[0,0,0]", "give position and length, or from and to"),
        ("[[scene.cylinder]]\nradius=1\nlength=1\nfrom=[0,0,0]\nto=[1,0,0]", r"not both \('length' and 'from'\)"),
        ("[[scene.capsule]]\nradius=1\nfrom=[0,0,0]\nto=[0,0,0]", "from and to are the same point"),
        (
            "[[scene.sphere]]\nname='it'\nposition=[0,0,0]\nradius=1\n" * 2,
            "has a sphere 'it', but the model already has a geom of that name",
        ),
    ],
)
def test_what_is_wrong_with_an_obstacle_is_reported_in_one_line(tmp_path, scene, words):
    with pytest.raises(UserError, match=words) as caught:
        loaded(tmp_path, scene)
    assert str(caught.value).startswith("tiny.toml: ")
    assert "\n" not in str(caught.value)


def test_meshes_and_height_fields_written_in_the_model_live_on_in_the_clips_text():
    assets = """<asset><mesh name="m" vertex="0 0 0 1 0 0 0 1 0 0 0 1"/>
      <hfield name="h" nrow="2" ncol="3" size="1 1 .5 .1" elevation="0 1 .5 .25 0 .75"/></asset>
      <worldbody><geom name="m" type="mesh" mesh="m" pos="1 2 3"/><geom name="h" type="hfield" hfield="h"/>"""
    text = FIGURE.replace("<worldbody>", assets, 1)
    before = mujoco.MjModel.from_xml_string(text)
    after = compose(mujoco.MjSpec.from_string(text)).model()
    np.testing.assert_allclose(after.hfield_data, before.hfield_data, atol=1e-6)
    np.testing.assert_allclose(after.geom("m").pos, before.geom("m").pos, atol=1e-6)
    np.testing.assert_allclose(after.mesh_vert, before.mesh_vert, atol=1e-6)
    (rock,) = (surface for surface in static_surfaces(after) if isinstance(surface, Hull))
    np.testing.assert_allclose(np.sort(rock.corners.T, axis=0)[-1], [2, 3, 4], atol=1e-6)
