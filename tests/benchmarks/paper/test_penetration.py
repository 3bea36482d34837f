"""How deep geoms are in the scene, where the answer is known by hand."""

import mujoco
import numpy as np
import pytest
from oracles import tells_height_fields
from paper.penetration import penetration

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
    assert (found.names, found.into, found.time[0]) == (("ball",), ("it",), 3)
    np.testing.assert_allclose(found.over_time, [0, 0, 0.03, 0.04], atol=3e-3)
    assert found.over_time[2] > 0.028
