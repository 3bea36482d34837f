"""A small biped of six hinges, and objects that stand about it, as MJCF."""

from __future__ import annotations

from collections.abc import Sequence

FREE = '<freejoint name="root"/>'
BOX = (
    '<body name="box" pos=".6 0 .15"><freejoint name="box_free"/><geom type="box" size=".15 .15 .15" mass="1"/></body>'
)
BALL = '<body name="ball" pos=".6 1 .15"><freejoint/><geom size=".15" mass="1"/></body>'
CART = (
    '<body name="cart" pos="2 0 .3"><freejoint name="cart_free"/><geom type="box" size=".4 .3 .1" mass="20"/>'
    + "".join(
        f'<body pos="{x} {y} -.15"><joint name="wheel {x} {y}" axis="0 1 0"/>'
        '<geom type="cylinder" size=".15 .03" euler="90 0 0" mass="1"/></body>'
        for x in (-0.3, 0.3)
        for y in (-0.3, 0.3)
    )
    + "</body>"
)
DOOR = (
    '<body name="door" pos="3 0 1"><joint name="door" axis="0 0 1"/><geom type="box" size=".05 .5 1"/>'
    '<body pos="-.1 .4 0"><joint name="handle" axis="1 0 0"/><geom size=".05"/></body></body>'
)
DRAWER = '<body name="drawer" pos="3 2 1"><joint type="slide" axis="1 0 0"/><geom type="box" size=".1 .5 .1"/></body>'
AXES = {"x": "1 0 0", "y": "0 1 0", "z": "0 0 1"}


def joints(names: Sequence[str]) -> str:
    """The joints of a body: "tx" is a slide along x, "ry" a hinge about y."""
    kinds = {"t": "slide", "r": "hinge"}
    return "".join(f'<joint name="{name}" type="{kinds[name[0]]}" axis="{AXES[name[1]]}"/>' for name in names)


def biped(root: str = FREE, prefix: str = "", x: float = 0.0, scale: float = 1.0) -> str:
    """A body `pelvis`, 0.8 m above the ground, with two legs of hip, knee and ankle."""
    legs = "".join(
        f'<body name="{prefix}{side}_thigh" pos="0 {y} -.05"><joint name="{prefix}{side}_hip" axis="0 1 0" '
        'range="-86 57"/><geom type="capsule" fromto="0 0 0 0 0 -.33" size=".05" mass="3"/>'
        f'<body name="{prefix}{side}_shin" pos="0 0 -.35"><joint name="{prefix}{side}_knee" axis="0 1 0" '
        'range="0 126"/><geom type="capsule" fromto="0 0 0 0 0 -.32" size=".04" mass="2"/>'
        f'<body name="{prefix}{side}_foot" pos="0 0 -.36"><joint name="{prefix}{side}_ankle" axis="0 1 0" '
        'range="-46 46"/><geom type="box" size=".1 .04 .02" pos=".04 0 -.02" mass="1"/></body></body></body>'
        for side, y in (("left", 0.1), ("right", -0.1))
    )
    return (
        f'<body name="{prefix}pelvis" pos="{x} 0 .8">{root}<geom type="box" size=".08 .12 .08" mass="8"/>{legs}</body>'
    )


def scene(*bodies: str) -> str:
    """A model of bodies on a floor."""
    floor = '<geom name="floor" type="plane" size="5 5 .1"/>'
    return f'<mujoco model="scene"><worldbody>{floor}{"".join(bodies)}</worldbody></mujoco>'
