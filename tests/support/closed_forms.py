"""A figure of several trees, on which rows are compared with adjoint sweeps."""

from __future__ import annotations

import numpy as np

from dynsplines.solver.array import Array

# two figures of their own, a chain that hangs on the world, welded bodies, a link of two balls, and a joint with
# another two behind it
WOOD = """
<mujoco><option gravity="0.3 0 -9.81"/>
<worldbody>
<body name="post" pos="1 0 0" quat=".8 .1 .5 0"><joint name="swing" type="ball"/>
  <geom type="capsule" size=".04" fromto="0 0 0 .02 0 -.3"/>
  <body name="tip" pos="0 .02 -.3"><joint name="turn" type="ball"/><geom type="box" size=".03 .05 .06" pos="0 .02 0"/>
    <body name="cap" pos="0 0 -.1" quat=".9 .3 0 .1"><geom size=".03"/></body></body></body>
<body name="trunk" pos="0 0 1"><freejoint name="root"/><geom type="capsule" size=".1" fromto="0 0 0 .05 0 .4"/>
  <body name="arm" pos="0.02 .2 .4" quat=".9 .1 -.2 .3"><joint name="shoulder" type="ball"/>
    <geom type="box" size=".05 .06 .2" pos="0 .03 -.2" euler="10 20 30"/>
    <body name="forearm" pos="0 .01 -.4"><joint name="elbow" type="ball"/>
      <geom type="capsule" size=".04" fromto="0 0 0 .02 0 -.3"/>
      <body name="thumb" pos="0 .03 -.3"><joint name="thumb" type="ball"/><geom size=".02" pos=".01 0 0"/></body>
      <body name="hand" pos="0 0 -.3"><joint name="wrist" type="ball"/><geom size=".03" pos="0 .01 -.02"/></body>
    </body></body>
  <body name="leg" pos="0 -.1 -.1"><joint name="hip" type="ball"/>
    <geom type="capsule" size=".06" fromto="0 0 0 0 0 -.5"/></body>
</body>
<body name="other" pos="0 2 1"><freejoint name="root2"/><geom type="box" size=".1 .2 .3"/>
  <body name="head" pos="0 0 .3"><joint name="neck" type="ball"/><geom size=".1" pos="0 .02 .1"/></body></body>
</worldbody></mujoco>"""


def assert_near(actual: Array, expected: Array, rtol: float) -> None:
    assert np.abs(expected).max() > 0.1
    np.testing.assert_allclose(actual, expected, rtol=0, atol=rtol * np.abs(expected).max())
