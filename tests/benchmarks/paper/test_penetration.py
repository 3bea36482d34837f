"""How deep geoms are in the scene, where the answer is known by hand."""

import mujoco
import numpy as np
import pytest
from oracles import tells_height_fields
from paper.penetration import penetration
from texts import read_data

SCENE = read_data("penetration.xml")


@pytest.fixture(scope="module")
def model() -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_string(SCENE)


def poses(*places: tuple[float, float, float]) -> np.ndarray:
    return np.array([[*place, 1, 0, 0, 0, 0] for place in places], float)


def test_only_moving_geoms_go_into_static_ones(model):
    assert penetration(model, np.zeros(1), poses((0, 0, 1))).names == ("ball", "b")
    inside_pillar = penetration(model, np.zeros(1), poses((-1.83, 0, 1)))
    assert inside_pillar.deepest == pytest.approx(0.03, abs=1e-5)
    assert inside_pillar.into[0] == "pillar"


def test_a_ball_sunk_in_the_floor_is_as_deep_as_it_is(model):
    time = np.array([0.0, 0.5, 1.0])
    found = penetration(model, time, poses((0, 0, 0.2), (0, 0, 0.03), (0, 0, 0.06)))
    assert found.deepest == pytest.approx(0.07, abs=1e-6)
    np.testing.assert_allclose(found.over_time, [0, 0.07, 0.04], atol=1e-6)
    assert found.names[0] == "ball"
    assert (found.time[0], found.into[0]) == (0.5, "floor")
    assert found.worst() == "ball in floor at 0.500 s"
    assert found.depth[1] == 0


def test_a_geom_without_a_name_is_reported_by_its_bodys(model):
    found = penetration(model, np.zeros(1), poses((0, 0, -0.6)))
    assert found.names[1] == "b"
    assert found.depth[1] == pytest.approx(0.15, abs=1e-6)


SHAPES = {
    "sphere": ('type="sphere" size=".3"', 0.3),
    "capsule": ('type="capsule" size=".05 .4" euler="0 90 0"', 0.05),
    "box": ('type="box" size=".4 .3 .2"', 0.2),
    "cylinder": ('type="cylinder" size=".2 .3"', 0.3),
    "ellipsoid": ('type="ellipsoid" size=".4 .3 .2"', 0.2),
    "mesh": ('type="mesh" mesh="m"', 0.25),
    "hfield": ('type="hfield" hfield="h"', 0.3),
}
ASSETS = """<asset><mesh name="m"
  vertex="-.4 -.4 0 .4 -.4 0 -.4 .4 0 .4 .4 0 -.4 -.4 .25 .4 -.4 .25 -.4 .4 .25 .4 .4 .25"/>
  <hfield name="h" nrow="4" ncol="4" size=".5 .5 .3 .1" elevation="1 1 1 1 1 1 1 1 0 1 1 1 0 0 1 1"/></asset>"""


@pytest.mark.parametrize(
    "shape", [pytest.param(name, marks=tells_height_fields) if name == "hfield" else name for name in SHAPES]
)
def test_a_ball_sunk_in_any_shape_is_as_deep_as_it_is(shape):
    geom, top = SHAPES[shape]
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco>{ASSETS}<worldbody><geom name="it" {geom} pos="1 2 3"/>'
        '<body><freejoint/><geom name="ball" size=".1"/></body></worldbody></mujoco>'
    )
    heights = np.array([0.5, 0.1, 0.07, 0.06])
    qpos = np.array([[1.01, 2.02, 3 + top + h, 1, 0, 0, 0] for h in heights])
    found = penetration(model, np.arange(4.0), qpos)
    assert found.into == ("it",)
    assert found.time[0] == 3
    np.testing.assert_allclose(found.over_time, [0, 0, 0.03, 0.04], atol=3e-3)
    assert found.over_time[2] > 0.028
