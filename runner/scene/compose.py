"""Figure and stage as one model: sky, light, floor and materials that the model lacks, and obstacles.

Obstacles are boxes, spheres, capsules and cylinders in metres. One with a `body` is part of a free object, in its axes.
Keyframes place the object, and hands can grasp it.
"""

from __future__ import annotations

import os
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from xml.sax.saxutils import quoteattr

import mujoco
import numpy as np

from dynsplines import models
from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.model import names_of_joints
from dynsplines.solver.surface.touch import SCENERY, grounds, moves

from ..errors import UserError, unknown, words_of
from ..system import size_limit
from ..system.mujoco_warnings import quietly
from . import file_access
from .assets import Assets, Scene, check_places, taken_along
from .file_access import elements, is_there, models_in
from .framing import STANDING, is_of_people_size, rest_box, size_of
from .mujoco_versions import lamp, portable_text, remove
from .triangles import HIDDEN_GROUP

PREFIX = "stage_"
GREY = mujoco.MjSpec().default.geom.rgba.copy()  # MuJoCo's default colour of a geom
BURIED = 0.005  # [m] depth in the floor that is permitted for a fixed figure
BELOW = 0.02  # [1] distance of an added floor below the figure's lowest point, relative to the figure's size
INPUTS = "give the name of a figure that ships, a path to MJCF or URDF, MJCF text or an MjSpec"
KINDS = {
    "box": mujoco.mjtGeom.mjGEOM_BOX,
    "sphere": mujoco.mjtGeom.mjGEOM_SPHERE,
    "capsule": mujoco.mjtGeom.mjGEOM_CAPSULE,
    "cylinder": mujoco.mjtGeom.mjGEOM_CYLINDER,
}


@dataclass(frozen=True)
class Obstacle:
    """A static geom, or a part of a free body.

    Attributes:
        kind: "box", "sphere", "capsule" or "cylinder".
        size: MuJoCo's size: half sizes, or radius and half length [m].
        place: The centre, (3,) [m].
        turn: The orientation, (4,) wxyz.
        ends: The end points of a capsule or cylinder, instead of `place` and `turn`, (6,) [m].
        color: Red, green, blue, opacity; None: that of the step.
        body: The body of which it is a part, with `place` and `turn` in its axes; None: the world.
        mass: The mass of the part [kg].
    """

    name: str
    kind: str
    size: tuple[float, ...]
    place: Array
    turn: Array
    ends: Array | None = None
    color: tuple[float, float, float, float] | None = None
    body: str | None = None
    mass: float | None = None

    def add_to(self, spec: mujoco.MjSpec, material: str) -> None:
        """Add the geom to the world of a spec, or to its body."""
        if any(geom.name == self.name for geom in spec.geoms):
            raise UserError(f"the scene has a {self.kind} '{self.name}', but the model already has a geom of that name")
        owner = spec.worldbody if self.body is None else spec.body(self.body)
        geom = owner.add_geom(name=self.name, type=KINDS[self.kind], contype=0, conaffinity=1 | SCENERY)
        if self.mass is not None:
            geom.mass = self.mass
        geom.size[: len(self.size)] = self.size
        if self.ends is None:
            geom.pos, geom.quat = self.place, self.turn
        else:
            geom.fromto = self.ends
        if self.color is None:
            geom.material = material
        else:
            geom.rgba = self.color


def figure_spec(figure: str, folder: Path | None = None) -> mujoco.MjSpec:
    """Return a shipped figure by name, or the model of an MJCF file (relative to `folder`)."""
    if figure in models.figures():
        return mujoco.MjSpec.from_string(models.figure_text(figure))
    path = (folder or Path()) / figure
    if not is_there(path):
        if Path(figure).suffix or "/" in figure:
            raise UserError(f"no file '{figure}'; a figure is a path to MJCF or one of: {', '.join(models.figures())}")
        raise UserError(unknown("figure", figure, models.figures()))
    size_limit.check_file(path)
    try:
        models_read = models_in(path)
        with quietly():
            spec = mujoco.MjSpec.from_file(str(path))
        check_places(spec, models_read)
        spec.compiler.discardvisual = False  # URDF drops materials and visual geoms, also those of the stage
    except UserError as error:
        raise UserError(f"{figure}: {error}") from None
    except ValueError as error:
        raise UserError(f"{figure}: MuJoCo cannot read it: {words_of(error)}") from None
    return spec


def is_text(source: object) -> bool:
    """Return whether a source is MJCF or URDF text, not a path."""
    return isinstance(source, str) and source.lstrip("\ufeff \t\r\n").startswith("<")


def spec_of(figure: object) -> tuple[mujoco.MjSpec, str]:
    """Return a model for changes, and its name in a clip's text: a shipped name, a path, or the model's name.

    Raises UserError for other objects, such as an MjModel, which MuJoCo cannot write as MJCF in general.
    """
    if isinstance(figure, mujoco.MjSpec):
        spec = figure.copy()
    elif isinstance(figure, str) and is_text(figure):
        spec = spec_of_text(figure)
    elif isinstance(figure, str | os.PathLike):
        called = os.fspath(figure)
        if not isinstance(called, str):
            raise UserError(f"figure is a path of bytes; {INPUTS}")
        return figure_spec(called), called if called in models.figures() else Path(called).resolve().as_posix()
    else:
        raise UserError(f"figure is of type {type(figure).__name__}; {INPUTS}")
    return spec, f"{spec.modelname or 'figure'}.xml"


def spec_of_text(text: str) -> mujoco.MjSpec:
    """Return the model of MJCF text, whose files are relative to the current folder."""
    for tag, attributes in elements(text):
        if tag in ("include", "model") and attributes.get("file"):
            file_access.check(Path(attributes["file"]), Path(), attributes["file"])
    try:
        with quietly():
            return mujoco.MjSpec.from_string(text)
    except ValueError as error:
        raise UserError(f"figure: MuJoCo cannot read the text: {words_of(error)}") from None


def stage(
    figure: str | mujoco.MjSpec,
    folder: Path | None = None,
    obstacles: Sequence[Obstacle] = (),
    joints: Sequence[tuple[str, str]] = (),
    keys: Sequence[tuple[str, str]] = (),
) -> tuple[Scene, mujoco.MjModel]:
    """Return a figure on its stage with obstacles, and the compiled model.

    Args:
        figure: The name of a shipped figure, the path of an MJCF file (relative to `folder`), or a model.
        joints: Names of joints that must exist, each after its label in errors.
        keys: Names of <key> elements of the model that the scene includes, each after its label in errors.

    Raises:
        UserError: For a model that cannot be read or compiled, and for unknown joints and <key> elements.
        ValueError: For a scene that MuJoCo cannot read.
    """
    spec = figure_spec(figure, folder) if isinstance(figure, str) else figure
    if spec.meshes or spec.hfields or spec.skins:  # otherwise compilation is fast, and posing reports the joint
        _check_names("joint", joints, spec_joint_names(spec))
    _check_names("key", keys, [key.name for key in spec.keys])
    scene = compose(spec, obstacles, keys={name for _, name in keys})
    return scene, scene.model()


def _check_names(kind: str, named: Sequence[tuple[str, str]], names: Collection[str]) -> None:
    """Raise UserError for the first pair of a label and a name that is unknown."""
    for label, name in named:
        if name not in names:
            raise UserError(f"{label}: {unknown(kind, name, filter(None, names))}")


def spec_joint_names(spec: mujoco.MjSpec) -> list[str]:
    """Return the names of a model's joints before it is compiled, as in `joint_names`."""
    names: list[str] = []
    bodies: list[tuple[str, int]] = []
    waiting = list(spec.worldbody.bodies)[::-1]
    while waiting:  # depth first, as MuJoCo numbers them
        body = waiting.pop()
        joints = list(body.joints)
        names += [joint.name for joint in joints]
        bodies.append((body.name, len(joints)))
        waiting += list(body.bodies)[::-1]
    return names_of_joints(names, bodies)


@quietly()
def compose(
    spec: mujoco.MjSpec,
    obstacles: Sequence[Obstacle] = (),
    *,
    bare: mujoco.MjModel | None = None,
    keys: Collection[str] = (),
) -> Scene:
    """Return a figure on its stage, complete with the files to which it refers.

    Only the <key> elements `keys` are included, because MuJoCo writes others with few digits or omits them.

    Args:
        bare: The compiled figure, if available; compilation of large meshes is slow.
        keys: Names of the model's <key> elements to include.
    """
    assets = taken_along(spec)
    poses = {key.name: np.array(key.qpos) for key in spec.keys if key.name in keys}
    spec.compiler.discardvisual = False
    for key in list(spec.keys):
        remove(spec, key)
    bare = _compile_spec(spec, assets) if bare is None else bare
    has_floor = bool(grounds(bare))
    is_staged = has_floor and any(material.name == PREFIX + "step" for material in spec.materials)  # by an earlier call
    parts = _stage(spec, bare, has_floor=has_floor)
    try:
        if not is_staged:
            _dress(spec, bare)
            spec.attach(parts, frame=spec.worldbody.add_frame(), prefix=PREFIX)
        if not has_floor and all(geom.name != "floor" for geom in spec.geoms):
            spec.geom(PREFIX + "floor").name = "floor"
        _add_bodies(spec, obstacles)
        for obstacle in obstacles:
            obstacle.add_to(spec, PREFIX + "step")
        model = _compile_spec(spec, assets)
        return Scene(_with_keys(portable_text(spec), poses, bare, model), assets)
    except ValueError as error:
        raise UserError(f"MuJoCo cannot compile the model with its stage: {words_of(error)}") from None


def _add_bodies(spec: mujoco.MjSpec, parts: Sequence[Obstacle]) -> None:
    """Add the bodies of the parts that have one, each with a free joint of its name, at rest at the world's origin."""
    for name in dict.fromkeys(part.body for part in parts if part.body is not None):
        names = {body.name for body in spec.bodies} | {joint.name for joint in spec.joints}
        if name in names:
            raise UserError(f"the scene has a body '{name}', but the model already has a body or joint of that name")
        spec.worldbody.add_body(name=name).add_freejoint(name=name)


def _with_keys(text: str, poses: Mapping[str, Array], bare: mujoco.MjModel, model: mujoco.MjModel) -> str:
    """Return a model's text with <key> elements for configurations (nq,) of the figure by name; an empty one is at
    rest."""
    keys = []
    for name, pose in poses.items():
        if pose.size not in (0, bare.nq):
            raise UserError(f"<key name={quoteattr(name)}>: qpos has {pose.size} numbers, not the figure's {bare.nq}")
        qpos = np.array(model.qpos0)
        qpos[: bare.nq] = pose if pose.size else bare.qpos0
        keys.append(f'    <key name={quoteattr(name)} qpos="{" ".join(map(repr, qpos.tolist()))}"/>\n')
    end = text.rindex("</mujoco>")
    return f"{text[:end]}\n  <keyframe>\n{''.join(keys)}  </keyframe>\n{text[end:]}" if keys else text


def _stage(spec: mujoco.MjSpec, bare: mujoco.MjModel, *, has_floor: bool) -> mujoco.MjSpec:
    """Return the parts of the stage that a model lacks. A model that no directional
    light lights from above gets only the stage's lights: others leave most of a figure's surroundings dark."""
    stage = mujoco.MjSpec.from_string(models.stage_text())
    has_light = is_lit(bare)
    has_sky = any(texture.type == mujoco.mjtTexture.mjTEXTURE_SKYBOX for texture in spec.textures)
    skies = [texture for texture in stage.textures if texture.type == mujoco.mjtTexture.mjTEXTURE_SKYBOX]
    for unwanted, present in ((list(stage.geoms), has_floor), (list(stage.lights), has_light), (skies, has_sky)):
        for element in unwanted if present else []:
            remove(stage, element)
    if not has_light:
        for light in spec.lights:
            light.active = False
        spec.visual, spec.stat = stage.visual, stage.stat
        if not is_of_people_size(bare):
            spec.stat.extent *= size_of(bare) / STANDING
    if not has_floor and not np.any(bare.jnt_type == JointKind.FREE):
        low = float(rest_box(bare)[0][2])
        if low < -BURIED:  # a fixed figure may reach below its origin
            stage.geom("floor").pos = [0.0, 0.0, low - BELOW * size_of(bare)]
    size, wanted = spec.visual.global_, stage.visual.global_
    size.offwidth, size.offheight = wanted.offwidth, wanted.offheight
    return stage


def is_lit(model: mujoco.MjModel) -> bool:
    """Return whether a directional light shines from above."""
    lights = np.flatnonzero(model.light_active & (model.light_dir[:, 2] < 0)).tolist()
    return any(lamp(model.light(light)) == "directional" for light in lights)


def _dress(spec: mujoco.MjSpec, bare: mujoco.MjModel) -> None:
    """Assign the stage's materials to geoms without colour and material: limbs light and dark in turn show bends."""
    floors, moving, depth = set(grounds(bare)), moves(bare), _depths(bare)
    for index, geom in enumerate(geoms_by_number(spec)):
        if geom.material or not np.allclose(geom.rgba, GREY) or bare.geom_group[index] >= HIDDEN_GROUP:
            continue
        if index in floors:
            geom.material = PREFIX + "floor"
        elif moving[index]:
            geom.material = PREFIX + ("dark" if depth[bare.geom_bodyid[index]] % 2 else "light")
        elif bare.geom_type[index] != int(mujoco.mjtGeom.mjGEOM_PLANE):
            geom.material = PREFIX + "step"


def _depths(model: mujoco.MjModel) -> list[int]:
    """Return the number of moving bodies on the chain from the world to each body, 0 for static ones."""
    depth = [0] * model.nbody
    for body in range(1, model.nbody):
        depth[body] = depth[model.body_parentid[body]] + int(model.body_jntnum[body] > 0)
    return depth


def compile_model(model: mujoco.MjSpec | Scene, where: object) -> mujoco.MjModel:
    """Return a compiled model; raises UserError that begins with `where` if MuJoCo cannot compile it."""
    with quietly():
        return _compile(model, where)


def _compile(model: mujoco.MjSpec | Scene, where: object) -> mujoco.MjModel:
    try:
        return model.compile() if isinstance(model, mujoco.MjSpec) else model.model()
    except ValueError as error:
        raise UserError(f"{where}: MuJoCo cannot compile it: {words_of(error)}") from None


def _compile_spec(spec: mujoco.MjSpec, assets: Assets) -> mujoco.MjModel:
    spec.assets = dict(assets)
    try:
        return _compile(spec, "the model")
    finally:
        spec.assets = {}  # otherwise MuJoCo warns about attached models without assets


def geoms_by_number(spec: mujoco.MjSpec) -> list[mujoco.MjsGeom]:
    """Return the geoms in the order of the compiled model, body by body."""
    return [geom for body in spec.bodies for geom in body.geoms]
