"""A biped and a quadruped whose legs are hinges, straight and bent at rest, small enough to read.

The biped's knees are straight at rest and its legs have six hinges each, as humanoid robots have. The quadruped stands
on spheres with its knees bent backward, three hinges a leg.
"""

from __future__ import annotations

LEG = """
<body name="{side}_thigh" pos="0 {y} -.05">
  <joint name="{side}_hip_yaw" axis="0 0 1" range="-60 60"/><joint name="{side}_hip_roll" axis="1 0 0" range="-40 40"/>
  <joint name="{side}_hip_pitch" axis="0 1 0" range="-130 60"/>
  <geom type="capsule" size=".05" fromto="0 0 0 0 0 -.3" mass="3"/>
  <body name="{side}_shin" pos="0 0 -.35"><joint name="{side}_knee" axis="0 1 0" range="-3 150"/>
    <geom type="capsule" size=".04" fromto="0 0 0 0 0 -.3" mass="2"/>
    <body name="{side}_foot" pos="0 0 -.35"><joint name="{side}_ankle_pitch" axis="0 1 0" range="-60 40"/>
      <joint name="{side}_ankle_roll" axis="1 0 0" range="-25 25"/>
      <geom type="box" size=".1 .04 .02" pos=".04 0 -.03" mass=".7"/></body></body></body>"""

ARM = """
<body name="{side}_arm" pos="0 {y} .4">
  <joint name="{side}_shoulder_pitch" axis="0 1 0" range="-180 60"/>
  <joint name="{side}_shoulder_roll" axis="1 0 0" range="-90 90"/>
  <joint name="{side}_shoulder_yaw" axis="0 0 1" range="-90 90"/>
  <geom type="capsule" size=".035" fromto="0 0 0 0 0 -.25" mass="1.5"/>
  <body name="{side}_forearm" pos="0 0 -.28"><joint name="{side}_elbow" axis="0 1 0" range="-140 0"/>
    <geom type="capsule" size=".03" fromto="0 0 0 0 0 -.22" mass="1"/>
    <site name="{side}_hand" pos="0 0 -.26"/></body></body>"""

BIPED = f"""
<mujoco model="biped"><compiler angle="degree" autolimits="true"/><worldbody>
  <geom name="floor" type="plane" size="5 5 .1"/>
  <body name="pelvis" pos="0 0 .8"><freejoint name="root"/>
    <geom type="box" size=".08 .12 .06" mass="8"/>
    {LEG.format(side="left", y=0.1)}{LEG.format(side="right", y=-0.1)}
    <body name="torso" pos="0 0 .1"><joint name="waist" axis="0 0 1" range="-60 60"/>
      <geom type="capsule" size=".1" fromto="0 0 .1 0 0 .35" mass="15"/>
      {ARM.format(side="left", y=0.18)}{ARM.format(side="right", y=-0.18)}</body>
  </body>
</worldbody></mujoco>"""
BIPED_HEIGHT = 0.8  # [m] of the pelvis when it stands

SHANK = """
<body name="{name}" pos="{x} {y} 0">
  <joint name="{name}_roll" axis="1 0 0" range="-45 45"/><joint name="{name}_hip" axis="0 1 0" range="-60 120"/>
  <geom type="capsule" size=".03" fromto="0 0 0 -.15 0 -.15" mass="1"/>
  <body name="{name}_shank" pos="-.15 0 -.15"><joint name="{name}_knee" axis="0 1 0" range="-60 35"/>
    <geom type="capsule" size=".02" fromto="0 0 0 .15 0 -.15" mass=".3"/>
    <geom type="sphere" size=".025" pos=".15 0 -.15" mass=".1"/></body></body>"""

QUADRUPED = f"""
<mujoco model="quadruped"><compiler angle="degree" autolimits="true"/><worldbody>
  <geom name="floor" type="plane" size="5 5 .1"/>
  <body name="trunk" pos="0 0 .325"><freejoint name="root"/>
    <geom type="box" size=".22 .09 .05" mass="8"/>
    {SHANK.format(name="FL", x=0.2, y=0.13)}{SHANK.format(name="FR", x=0.2, y=-0.13)}
    {SHANK.format(name="RL", x=-0.2, y=0.13)}{SHANK.format(name="RR", x=-0.2, y=-0.13)}
  </body>
</worldbody></mujoco>"""
QUADRUPED_HEIGHT = 0.325  # [m] of the trunk when it stands
