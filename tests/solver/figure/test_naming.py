"""What geoms are called."""

from __future__ import annotations

import mujoco

from dynsplines.solver.figure.naming import geom_name

TEXT = """
<mujoco><worldbody><geom size="1"/>
  <body name="foot"><geom name="sole" size="1"/><geom size="1"/></body>
  <body name="leg"><geom size="1"/><geom size="1"/><geom name="leg 2" size="1"/></body>
  <body><geom size="1"/></body>
</worldbody></mujoco>"""


def test_a_geom_without_a_name_is_called_after_its_body_and_no_two_alike():
    model = mujoco.MjModel.from_xml_string(TEXT)
    found = [geom_name(model, geom) for geom in range(model.ngeom)]
    assert found == ["geom 0", "sole", "foot", "leg 1", "geom 4", "leg 2", "geom 6"]
