"""Figures as MJCF: small ones, robots, bipeds, limbs, chains, meshes and the ground below them."""

import struct
from collections.abc import Sequence
from copy import copy
from functools import cache
from pathlib import Path

import mujoco
import numpy as np
from texts import read_data

from dynsplines import models
from dynsplines.clip import load
from dynsplines.clip.parse import Parsed
from dynsplines.scene.assets import Scene
from dynsplines.solver.array import Array
from dynsplines.solver.cache import Cache
from dynsplines.solver.contacts import Contact
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import (
    Bend,
    BendLimits,
    CovariantAcceleration,
    Penalty,
    RootAcceleration,
    Support,
    UnitMagnitude,
)
from dynsplines.solver.surface import Plane
from dynsplines.solver.surface.points import Point, places_of

# Small figures as MJCF, and figures of them.

BALL_TREE = read_data("ball_tree.xml")

ONE_BALL = '<mujoco><worldbody><body><joint type="ball"/><geom size=".1"/></body></worldbody></mujoco>'

EVERY_JOINT = read_data("every_joint.xml")

MIXED = read_data("mixed.xml")

FIGURES = {
    "ball tree, world": (BALL_TREE, "world"),
    "ball tree, joint": (BALL_TREE, "joint"),
    "every joint": (EVERY_JOINT, "joint"),
    "mixed": (MIXED, "auto"),
}

BALL = '<mujoco><worldbody><body><freejoint/><geom size=".1"/></body></worldbody></mujoco>'
TINY = """
<mujoco><option gravity="0 0 -9.81"/><worldbody><body pos="0 0 1"><freejoint name="root"/><geom size=".1" mass="3"/>
  <body name="shin" pos="0 0 -.2" quat=".9 .1 -.2 .3"><joint name="knee" type="ball"/>
    <geom type="capsule" size=".04" fromto="0 0 0 .01 0 -.3" mass="1"/></body></body></worldbody></mujoco>"""


LEG = read_data("leg_of_shapes.xml")
CHAIN = (
    '<mujoco><worldbody><body><joint type="ball"/><geom size=".1" pos="0 0 .2"/><body pos="0 0 .4"><joint type="{}"/>'
    '<geom size=".1" pos="0 0 .2"/></body></body></worldbody></mujoco>'
)
CHAINS = [(BALL_TREE, "world"), (CHAIN.format("ball"), "world"), (CHAIN.format("hinge"), "joint")]


def figure_of(text: str, coordinates: str = "auto") -> Figure:
    return Figure(mujoco.MjModel.from_xml_string(text), coordinates)


@cache
def figure_named(name: str) -> Figure:
    """One of FIGURES, built once in a process; not to be changed."""
    return figure_of(*FIGURES[name])


def with_armature(figure: Figure, rng: np.random.Generator) -> Figure:
    """The same figure with rotor inertia on every joint, one value a joint."""
    model = copy(figure.model)
    model.dof_armature[:] = rng.uniform(0.1, 1, model.njnt)[model.dof_jntid]
    mujoco.mj_setConst(model, mujoco.MjData(model))
    return Figure(model, figure.coordinates)


def link_named(figure: Figure, name: str) -> int | None:
    """The index of the link that a joint or a body of this name moves, or None."""
    by_joint = next((i for i, link in enumerate(figure.links) if i and link.name == name), None)
    body = mujoco.mj_name2id(figure.model, mujoco.mjtObj.mjOBJ_BODY, name)
    return int(figure.body_link[body]) if by_joint is None and body > 0 else by_joint


# A small robot with a body for every hinge, as robots have them: hip pitch, hip roll, hip yaw.


ANDROID = read_data("android.xml")


# A small biped of six hinges, and objects that stand about it, as MJCF.

FREE = '<freejoint name="root"/>'
BOX = (
    '<body name="box" pos=".6 0 .15"><freejoint name="box_free"/><geom type="box" size=".15 .15 .15" mass="1"/></body>'
)
OBJECT_BALL = '<body name="ball" pos=".6 1 .15"><freejoint/><geom size=".15" mass="1"/></body>'
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


# A biped of six hinges a leg, with straight knees at rest, and a quadruped of three, with knees bent backward.

BIPED = read_data("biped.xml")
BIPED_HEIGHT = 0.8  # [m] of the pelvis when it stands

QUADRUPED = read_data("quadruped.xml")
QUADRUPED_HEIGHT = 0.325  # [m] of the trunk when it stands


# A chain of hinges, keyframes of it, and soft constraints for it.

SMOOTHNESS: list[tuple[Penalty, float]] = [
    (CovariantAcceleration(), 1.0),
    (RootAcceleration(), 1.0),
    (UnitMagnitude(), 1.0),
]
PENALTIES: list[tuple[Penalty, float]] = [
    (CovariantAcceleration(), 1.0),
    (UnitMagnitude(), 0.5),
    (RootAcceleration(), 1.0),
]


def hinged() -> Figure:
    arm = '<joint axis="0 1 0"/><geom size=".1"/>'
    return figure_of(f'<mujoco><worldbody><body>{arm}<body pos="0 0 -1">{arm}</body></body></worldbody></mujoco>')


def hinge_keys() -> list[Frame]:
    return [Frame.key(t, [a, b]) for t, a, b in [(0, 0.0, 1.0), (0.5, 1.0, -1.0), (1.4, 0.2, 0.4), (2, -1.0, 0)]]


# A limb with a knee, and the limits of bends.


def limits_of(figure: Figure) -> BendLimits:
    """Bounds on every ball joint."""
    joints = figure.tables.ball_links
    return BendLimits(tuple(Bend(f"{i}", i, KNEE, np.array([0.0, 0, -1])) for i in joints), 0.1, 0.2, 0.3)


LIMB = """
<mujoco><worldbody><body name="upper" pos="0 0 1"><freejoint/><geom size=".1"/>
  <body name="lower" pos="0 0 -.4" quat="{quat}"><joint name="joint" type="ball"/><geom size=".1"/></body></body>
</worldbody></mujoco>"""
DOWN = np.array([0.0, 0, -1])
TEN = float(np.radians(10))
KNEE, ELBOW = np.array([0.0, 1, 0]), np.array([0.0, -1, 0])


def limb(coordinates: str = "world", quat: str = "1 0 0 0") -> Figure:
    return figure_of(LIMB.format(quat=quat), coordinates)


def limits(lateral: np.ndarray, *, least: float = 0.0, sideways: float = TEN, twist: float = TEN) -> BendLimits:
    return BendLimits((Bend("joint", 2, lateral, DOWN),), least, sideways, twist)


# A floor, a slope, points that touch them and stances on them.

UP = np.array([0.0, 0, 1])
FLOOR = Plane("floor", np.zeros(3), UP)
SLOPE = Plane("slope", np.array([0.1, 0, 0.2]), np.array([0.6, 0, 0.8]))


def random_points(figure: Figure, rng: np.random.Generator) -> tuple[Point, ...]:
    """Two points on every link, so that links repeat."""
    indices = [*range(1, len(figure.links)), *range(1, len(figure.links))]
    return tuple(Point(f"p{n}", i, 0.3 * rng.normal(size=3), rng.uniform(0, 0.2)) for n, i in enumerate(indices))


def two_points(figure: Figure) -> tuple[Point, ...]:
    """A point on the first link and one on the last."""
    last = len(figure.links) - 1
    return Point("a", 1, np.array([0.1, 0.2, -0.3]), 0.05), Point("b", last, np.array([0.0, 0.1, -0.2]))


def plane_below(samples: Samples, normal: Array = UP) -> Plane:
    """A plane under both points."""
    centres, _ = places_of(two_points(samples.figure), samples)
    return Plane("floor", (np.einsum("i,ins->ns", normal, centres).min() - 0.3) * normal, normal)


def stance_of(link: int, first: float, last: float) -> Contact:
    """A contact whose position drifts."""
    places = np.array([[0.1, 0.2, 0], [0.13, 0.2, 0.01]])
    point = Point("p", link, np.array([0.1, 0.2, -0.3]))
    return Contact(point, first, last, places=places, times=np.array([first, last]))


def contact_on(point: Point, first: float, last: float, normal: Array) -> Contact:
    """A contact with a plane of a normal (3,)."""
    return Contact(point, first, last, surface=Plane("ground", np.zeros(3), normal))


def support_of(figure: Figure, rng: np.random.Generator) -> Support:
    """Footings on the first and the last link of the root's tree, one on a slope, with a flight besides."""
    inside, slope = np.flatnonzero(figure.tables.path[:, 1]), rng.normal(size=3)
    ends, places = (int(inside[0]), int(inside[-1])), rng.normal(size=(3, 3))
    footings = (
        contact_on(Point("a", ends[0], places[0]), 0.0, 1.0, UP),
        contact_on(Point("b", ends[1], places[1]), 0.6, 1.6, slope / np.linalg.norm(slope)),
        contact_on(Point("c", ends[1], places[2]), 0.6, 1.2, UP),
    )
    return Support.of(figure, 1, footings, ((0.7, 0.9), (1.9, 2.2)))


# A mesh as a file's bytes.


def stl(size: float) -> bytes:
    """A tetrahedron."""
    corners = size * np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
    triangles = b"".join(struct.pack("<12fH", 0, 0, 0, *corners[list(face)].ravel(), 0) for face in faces)
    return bytes(80) + struct.pack("<I", len(faces)) + triangles


# Two figures, a chain that hangs on the world, welded bodies, and a joint with two joints on it.
WOOD = read_data("two_trees.xml")


def assert_near(actual: Array, expected: Array, rtol: float) -> None:
    assert np.abs(expected).max() > 0.1
    np.testing.assert_allclose(actual, expected, rtol=0, atol=rtol * np.abs(expected).max())


# Equal scenes and figures are built once in a process; then equal poses of several clips are found once, too.

MOST = 50  # [1] scenes, and figures, that are kept
BUILT = load.figure_of
COMPOSED = load.scene_and_figure
_figures: Cache[Figure] = Cache(MOST)
_staged: Cache[tuple[Scene, Figure]] = Cache(MOST)


def shared_figure_of(scene: Scene, where: str) -> Figure:
    return _figures.get(_key(scene), lambda: BUILT(scene, where))


def scene_and_figure(
    source: Parsed, figure_file: str | None = None, spec: mujoco.MjSpec | None = None
) -> tuple[Scene, Figure]:
    text = None if spec is not None else _self_contained(figure_file or source.table.figure, source.folder)
    if text is None:
        return _shared(*COMPOSED(source, figure_file, spec))
    key = text, repr(source.table.scene), frozenset(row.others for row in source.table.keyframe)
    return _staged.get(key, lambda: _shared(*COMPOSED(source, figure_file)))


def _shared(scene: Scene, figure: Figure) -> tuple[Scene, Figure]:
    return scene, _figures.get(_key(scene), lambda: figure)


def _key(scene: Scene) -> tuple[object, ...]:
    return scene.mjcf, tuple(sorted(scene.assets.items()))


def _self_contained(figure: str, folder: Path | None) -> str | None:
    """Return the text of a figure; None if it refers to other files, or cannot be read."""
    if figure in models.figures():
        return models.figure_text(figure)
    try:
        text = ((folder or Path()) / figure).read_text(encoding="utf-8")
    except (OSError, ValueError):
        return None
    return None if "file" in text else text


def share() -> None:
    """From here on, in whatever is loaded."""
    load.figure_of, load.scene_and_figure = shared_figure_of, scene_and_figure


# A model times a factor, by its MjSpec: lengths, masses, inertias, and gravity on demand.

SLIDE = mujoco.mjtJoint.mjJNT_SLIDE


def scaled(text: str, factor: float, *, gravity: bool = False) -> mujoco.MjSpec:
    """The model in MJCF text with all lengths times a factor, of the same density."""
    spec = mujoco.MjSpec.from_string(text)
    for body in spec.bodies:
        body.pos = factor * np.array(body.pos)
        body.ipos = factor * np.array(body.ipos)
        body.mass *= factor**3
        body.inertia = factor**5 * np.array(body.inertia)
        body.fullinertia = factor**5 * np.array(body.fullinertia)
        for geom in body.geoms:
            geom.pos, geom.size = factor * np.array(geom.pos), factor * np.array(geom.size)
            geom.fromto = factor * np.array(geom.fromto)
            geom.mass *= factor**3
        for site in body.sites:
            site.pos, site.size = factor * np.array(site.pos), factor * np.array(site.size)
            site.fromto = factor * np.array(site.fromto)
        for joint in body.joints:
            joint.pos = factor * np.array(joint.pos)
            if joint.type == SLIDE:
                joint.range = factor * np.array(joint.range)
    for camera in spec.cameras:
        camera.pos = factor * np.array(camera.pos)
    if gravity:
        spec.option.gravity = factor * np.array(spec.option.gravity)
    return spec


def enlarged(model: mujoco.MjModel, qpos: np.ndarray, factor: float) -> np.ndarray:
    """Configurations (K, nq) of the scaled model that are those of a model."""
    out = np.array(qpos, float)
    for kind, start in zip(model.jnt_type, model.jnt_qposadr, strict=True):
        if kind == mujoco.mjtJoint.mjJNT_FREE:
            out[:, start : start + 3] *= factor
        elif kind == SLIDE:
            out[:, start] *= factor
    return out
