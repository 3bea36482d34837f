"""A small robot with a body for every hinge, as robots have them: hip pitch, hip roll, hip yaw."""

from __future__ import annotations


def _leg(side: str, sign: float) -> str:
    corners = "".join(
        f'<geom name="{side}_sole_{i}" type="sphere" size=".01" pos="{x} {y} -.05" mass=".01"/>'
        for i, (x, y) in enumerate([(-0.05, -0.03), (-0.05, 0.03), (0.13, -0.03), (0.13, 0.03)])
    )
    return f"""
<body name="{side}_hip_pitch_link" pos="0 {0.1 * sign} -.05">
 <joint name="{side}_hip_pitch" axis="0 1 0" range="-130 60"/>
 <geom type="sphere" size=".03" mass=".3"/>
 <body name="{side}_hip_roll_link"><joint name="{side}_hip_roll" axis="1 0 0" range="-40 40"/>
  <geom type="sphere" size=".03" mass=".3"/>
  <body name="{side}_hip_yaw_link"><joint name="{side}_hip_yaw" axis="0 0 1" range="-60 60"/>
   <geom type="capsule" size=".04" fromto="0 0 -.05 0 0 -.3" mass="1.5"/>
   <body name="{side}_knee_link" pos="0 0 -.35"><joint name="{side}_knee" axis="0 1 0" range="-2 140"/>
    <geom type="capsule" size=".035" fromto="0 0 -.05 0 0 -.27" mass="1"/>
    <body name="{side}_ankle_pitch_link" pos="0 0 -.33"><joint name="{side}_ankle_pitch" axis="0 1 0" range="-60 50"/>
     <geom type="sphere" size=".02" mass=".1"/>
     <body name="{side}_ankle_roll_link"><joint name="{side}_ankle_roll" axis="1 0 0" range="-25 25"/>{corners}
      <geom type="box" size=".08 .025 .015" pos=".04 0 -.03" mass=".3"/>
     </body></body></body></body></body></body>"""


def _arm(side: str, sign: float) -> str:
    return f"""
<body name="{side}_shoulder_pitch_link" pos="0 {0.13 * sign} .25"><joint name="{side}_shoulder_pitch" axis="0 1 0"/>
 <geom type="sphere" size=".03" mass=".3"/>
 <body name="{side}_shoulder_roll_link"><joint name="{side}_shoulder_roll" axis="1 0 0"/>
  <geom type="sphere" size=".03" mass=".3"/>
  <body name="{side}_shoulder_yaw_link"><joint name="{side}_shoulder_yaw" axis="0 0 1"/>
   <geom type="capsule" size=".03" fromto="0 0 -.03 0 0 -.18" mass=".6"/>
   <body name="{side}_elbow_link" pos="0 0 -.22"><joint name="{side}_elbow" axis="0 1 0" range="-130 2"/>
    <geom type="capsule" size=".025" fromto="0 0 -.03 0 0 -.2" mass=".5"/>
    <body name="{side}_wrist_roll_link" pos="0 0 -.22"><joint name="{side}_wrist_roll" axis="0 0 1" range="-90 90"/>
     <geom type="sphere" size=".03" mass=".2"/></body></body></body></body></body>"""


ANDROID = f"""<mujoco model="android"><worldbody>
<body name="pelvis" pos="0 0 .79"><freejoint name="floating_base"/>
 <geom type="box" size=".06 .1 .05" mass="4"/>{_leg("left", 1)}{_leg("right", -1)}
 <body name="waist_yaw_link" pos="0 0 .06"><joint name="waist_yaw" axis="0 0 1" range="-120 120"/>
  <geom type="sphere" size=".04" mass=".5"/>
  <body name="torso_link"><joint name="waist_pitch" axis="0 1 0" range="-30 50"/>
   <geom type="capsule" size=".08" fromto="0 0 .1 0 0 .25" mass="6"/>{_arm("left", 1)}{_arm("right", -1)}
  </body></body></body></worldbody></mujoco>"""
