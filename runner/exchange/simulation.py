"""A scene for `mj_step`: the figure collides with the scenery, and every joint has position actuators.

The figure's geoms that collide in the model still collide, all of them if none does, and solid geoms of the scenery
collide with them. A figure without colliding geoms in the model does not collide with itself. The model's actuators and
the limits of their forces on joints are replaced:
    force = kp (ctrl − q) − kv q'            hinges and slides; a ball joint has three, about its x, y and z
with q the joint's coordinate, for a ball joint its rotation vector. The `ctrl` of a key is q + (kv q' + τ) / kp of the
motion. Its torque τ is `mj_inverse` of this scene without contacts, minus the ground reactions. So on the
motion the actuators exert exactly τ, and off it they pull back. The gains:
    kp = m ω², ω = 2π · 8 Hz, m the joint's inertia at rest (of a ball joint the largest). It is at least
         0.7 / rad of weight times height for joints of limbs with soles, as one limb may support the whole figure (for
         a slide, 0.1 m replaces a radian), and at least the motion's largest torque / rad, so that `ctrl` stays near
         q: errors of ball joints wrap at half a turn
    kv = kp · 0.04 s, which is critical damping, 2 / ω
A free root has no actuator. Gains are in N m/rad and N m s/rad, of slides in N/m and N s/m.

Of the model's actuators, their defaults and its simulation options, only the flags that disable forces of the figure
itself (`FIGURE_FLAGS`) are inherited, as the feed-forward torque includes these.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from xml.etree import ElementTree

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.figure import dynamics
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.root import sliding_joints
from dynsplines.solver.surface.touch import is_scenery, movers, overlapping_pairs, solids

from ..clip import load as clip
from ..errors import list_names
from ..measure.forces import Forces
from ..motion import Sampled
from ..scene.compose import geoms_by_number
from ..scene.framing import size_of, spread
from ..scene.mujoco_versions import portable_text, remove
from ..scene.roles import unique
from ..system.mujoco_warnings import quietly
from .skeleton import hierarchy

FREQUENCY = 8.0  # [Hz] natural frequency of a limb on its actuators, several times that of human motion
STANDING = 0.7  # [1/rad] least kp of a supporting limb over weight times height; figures fall at 0.55, bounce above 0.7
GIVE = 0.1  # [m] most offset of `ctrl` from a slide that its force causes, and 1 rad from a joint that rotates
TIMESTEP_RANGE = (1e-4, 0.002)  # [s] least and largest time step
ITERATIONS = (100, 50)  # least limits of iterations of the constraint solver and its line search
SOFTNESS = (0.01, 1.5)  # time constant [s] and damping of contacts: feet land without bouncing
IMPEDANCE = 10.0  # least `impratio`, friction to normal impedance, so that standing feet do not creep
GRIP = 1.0  # least coefficient of friction of static geoms
SLIDING = 3  # `condim` of a contact with sliding friction
OVERLAP = 2e-4  # fraction of the figure's size from which penetrating bodies count as overlapping by design
CONSTRAINED = ("EQUALITY", "FRICTIONLOSS", "LIMIT")  # forces other than contacts that the flag CONSTRAINT disables
FIGURE_FLAGS = ("GRAVITY", "PASSIVE", "SPRING", "DAMPER", *CONSTRAINED, "SENSOR")
ACTUATORS = (
    "general", "motor", "position", "velocity", "intvelocity", "damper", "cylinder", "muscle", "adhesion", "dcmotor",
    "pid", "orientation", "plugin",
)  # fmt: skip
DROPPED = {  # limits of actuator forces, and of memory, as more geoms collide than in the model
    "joint": ("actuatorfrcrange", "actuatorfrclimited", "actuatorgravcomp"),
    "size": ("memory", "njmax", "nconmax", "nkey", "nstack"),
}


@dataclass(frozen=True)
class Drive:
    """A position actuator: its joint, the axis of a ball joint that it acts about or None, and its gains."""

    name: str
    joint: int
    axis: int | None
    kp: float
    kv: float


@dataclass(frozen=True)
class Simulation:
    """A scene to simulate.

    root     its MJCF, without keys
    model    the same, compiled
    control  (T, nu) `ctrl` at the samples of the motion
    notes    changes of the model
    """

    root: ElementTree.Element
    model: mujoco.MjModel
    control: Array
    notes: tuple[str, ...]

    @classmethod
    def of(cls, sampled: Sampled) -> Simulation:
        """Return the scene of a motion; raises ValueError if MuJoCo cannot compile it."""
        forces = Forces.of(sampled)
        actuators = drives(sampled, forces)
        root, notes = _scene(sampled, actuators)
        with quietly():
            model = mujoco.MjModel.from_xml_string(
                ElementTree.tostring(root, encoding="unicode"), dict(sampled.motion.scene.assets)
            )
        return cls(root, model, targets(sampled, replace(forces, model=model), actuators), tuple(notes))


def drives(sampled: Sampled, forces: Forces) -> list[Drive]:
    """Return the actuators of a figure, in the order of its joints."""
    model, least, joints = sampled.model, _least(sampled), joint_names(sampled.model)
    largest = np.abs(np.nan_to_num(forces.torques)).max(axis=0, initial=0)
    out: list[Drive] = []
    for joint in range(model.njnt):
        kind, dof = JointKind(model.jnt_type[joint]), int(model.jnt_dofadr[joint])
        if kind is JointKind.FREE:
            continue
        dofs = slice(dof, dof + kind.freedom)
        inertia = float(model.dof_M0[dofs].max())
        offset = GIVE if kind is JointKind.SLIDE else 1.0
        kp = _round(max(inertia * (2 * np.pi * FREQUENCY) ** 2, least[joint], largest[dofs].max() / offset))
        kv = _round(kp / (np.pi * FREQUENCY))  # critical damping
        for axis in range(3) if kind is JointKind.BALL else (None,):
            name = joints[joint] if axis is None else f"{joints[joint]}_{'xyz'[axis]}"
            out.append(Drive(unique([name], [drive.name for drive in out])[0], joint, axis, kp, kv))
    return out


def joint_names(model: mujoco.MjModel) -> list[str]:
    """Return the joints' names, with generated ones for unnamed joints."""
    out = [model.joint(joint).name for joint in range(model.njnt)]
    for joint, name in enumerate(out):
        out[joint] = name or unique([f"joint{joint}"], out)[0]
    return out


def _round(gain: float) -> float:
    """Round to three digits, for legibility."""
    return float(f"{gain:.3g}")


def _least(sampled: Sampled) -> Array:
    """Return the gain (njnt,) that supports the whole figure, for joints between its root and its soles."""
    figure, model = sampled.figure, sampled.model
    out = np.zeros(model.njnt)
    points = clip.clip_from_motion(sampled.motion).context.points
    if figure.root is None or not points:
        return out
    root = figure.root.link
    gain = STANDING * dynamics.weight(figure, root) * dynamics.height(figure, root)
    for link in _legs(figure, {point.link for point in points}):
        joint = figure.links[link].joint
        out[joint] = gain / GIVE**2 if model.jnt_type[joint] == JointKind.SLIDE else gain
    return out


def _legs(figure: Figure, feet: set[int]) -> set[int]:
    """Return the links from the feet up to the root."""
    out: set[int] = set()
    for foot in feet:
        link = foot
        while link:
            out.add(link)
            link = figure.links[link].parent
    return out


def targets(sampled: Sampled, forces: Forces, actuators: list[Drive]) -> Array:
    """Return `ctrl` (T, nu) at the samples; forces: those of the scene to simulate, which are added if known."""
    model, torques = forces.model, np.nan_to_num(forces.torques)
    out = np.zeros((len(sampled.qpos), len(actuators)))
    for column, drive in enumerate(actuators):
        first, dof = int(model.jnt_qposadr[drive.joint]), int(model.jnt_dofadr[drive.joint])
        if drive.axis is None:
            at = sampled.qpos[:, first]
        else:
            at = quat.rotation_vector(sampled.qpos[:, first : first + 4])[:, drive.axis]
            dof += drive.axis
        out[:, column] = at + (drive.kv * sampled.qvel[:, dof] + torques[:, dof]) / drive.kp
    return out


def _scene(sampled: Sampled, actuators: list[Drive]) -> tuple[ElementTree.Element, list[str]]:
    """Return the model's MJCF with colliding geoms, actuators and options, and notes on what is overridden."""
    spec = sampled.motion.scene.spec()
    model, names = sampled.model, joint_names(sampled.model)
    _set_options(spec, model)
    notes = _collide(spec, model)
    for name, joint in zip(names, spec.joints, strict=True):
        joint.name = name
    with quietly():
        overlaps = _exclude_overlaps(spec, spec.compile(), sampled.qpos)
        if overlaps:
            spec.compile()
    if sliding := sliding_joints(model):
        moved = ", ".join(names[joint] for joint in sliding)
        notes.append(f"joints on which the figure slides have actuators too, which carry it: {moved}")
    notes += overlaps
    root = ElementTree.fromstring(portable_text(spec))
    _remove_actuators(root)
    _add_actuators(root, names, actuators)
    return root, notes


def _flag(name: str) -> int:
    """Return a bit of mjtDisableBit, 0 if this version of MuJoCo lacks it."""
    return int(getattr(mujoco.mjtDisableBit, f"mjDSBL_{name}", 0))


def _set_options(spec: mujoco.MjSpec, model: mujoco.MjModel) -> None:
    """Set the options of `mj_step`."""
    option, flags = spec.option, int(model.opt.disableflags)
    if flags & _flag("CONSTRAINT"):
        flags |= sum(map(_flag, CONSTRAINED))
    option.disableflags = flags & sum(map(_flag, FIGURE_FLAGS))
    option.enableflags = int(model.opt.enableflags) & int(mujoco.mjtEnableBit.mjENBL_ENERGY)
    option.disableactuator = 0
    option.timestep = float(np.clip(model.opt.timestep, *TIMESTEP_RANGE))
    option.integrator = int(mujoco.mjtIntegrator.mjINT_IMPLICITFAST)  # others are unstable with stiff damping
    option.cone = int(mujoco.mjtCone.mjCONE_ELLIPTIC)
    option.impratio = max(float(model.opt.impratio), IMPEDANCE)
    option.solver, option.jacobian = int(mujoco.mjtSolver.mjSOL_NEWTON), int(mujoco.mjtJacobian.mjJAC_AUTO)
    option.iterations = max(int(model.opt.iterations), ITERATIONS[0])
    option.ls_iterations = max(int(model.opt.ls_iterations), ITERATIONS[1])
    option.tolerance = min(float(model.opt.tolerance), 1e-8)
    option.noslip_iterations = 0


def _remove_actuators(root: ElementTree.Element) -> None:
    """Remove the model's actuators, their defaults, elements that refer to them, and limits of joint forces."""
    _remove_children(root, lambda each: each.tag in ("actuator", "keyframe"))
    for defaults in root.iter("default"):
        _remove_children(defaults, lambda each: each.tag in ACTUATORS)
    for parent in list(root.iter()):
        _remove_children(parent, lambda each: "actuator" in each.attrib or each.get("objtype") == "actuator")
    for section in root.findall("custom"):
        _remove_children(section, lambda each: each.tag == "tuple" and not len(each))
    for tag, names in DROPPED.items():
        for element in root.iter(tag):
            for name in names:
                element.attrib.pop(name, None)


def _remove_children(parent: ElementTree.Element, chosen: Callable[[ElementTree.Element], bool]) -> None:
    for child in [element for element in parent if chosen(element)]:
        parent.remove(child)


def _add_actuators(root: ElementTree.Element, names: list[str], actuators: list[Drive]) -> None:
    section = ElementTree.SubElement(root, "actuator")
    for drive in actuators:
        values = {"name": drive.name, "joint": names[drive.joint], "kp": f"{drive.kp:g}", "kv": f"{drive.kv:g}"}
        if drive.axis is not None:
            values["gear"] = " ".join("1" if axis == drive.axis else "0" for axis in range(3))
        ElementTree.SubElement(section, "position", values)


def _collide(spec: mujoco.MjSpec, model: mujoco.MjModel) -> list[str]:
    """Let the figure collide with the scenery; return notes on changes of the model."""
    geoms, notes = geoms_by_number(spec), []
    base = _bases(model)
    moving = movers(model)
    still = [i for i in solids(model) if int(model.geom_bodyid[i]) not in base]
    figure = [i for i in moving if not is_scenery(model)[i]]
    if not any(geoms[i].contype or geoms[i].conaffinity for i in figure):
        for i in figure:
            geoms[i].contype, geoms[i].conaffinity = 1, 0
            geoms[i].solref[:2] = SOFTNESS
    types, affinities = 1, 1
    for i in moving:
        types, affinities = types | geoms[i].contype, affinities | geoms[i].conaffinity
    for i in still:
        geoms[i].contype, geoms[i].conaffinity = affinities, types
        geoms[i].solref[:2] = SOFTNESS
    slippery = [i for i in still if geoms[i].condim < SLIDING or geoms[i].friction[0] < GRIP]
    for i in slippery:
        geoms[i].condim, geoms[i].friction[0] = max(geoms[i].condim, SLIDING), max(geoms[i].friction[0], GRIP)
    if slippery:
        notes.append(f"the scene to simulate gives static geoms a coefficient of friction of at least {GRIP:g}")
    for pair in list(spec.excludes):
        names = (pair.bodyname1, pair.bodyname2)
        if "world" in names:
            other = names[names.index("world") - 1]
            notes.append(f"the scene to simulate lets the world and '{other}' collide, which the model excludes")
            remove(spec, pair)
    for first, second in sorted({(body, int(model.geom_bodyid[solid])) for body, solid in overlapping_pairs(model)}):
        _exclude(spec, first, second)  # a limb and its fixed base overlap by design
    return notes


def _bases(model: mujoco.MjModel) -> set[int]:
    """Return the static bodies, other than the world, that carry limbs and so are parts of a figure."""
    moving = np.flatnonzero(model.body_weldid != 0).tolist()
    return {base for body in moving for base in hierarchy.above(model, body) if model.body_weldid[base] == 0}


def _exclude_overlaps(spec: mujoco.MjSpec, model: mujoco.MjModel, qpos: Array) -> list[str]:
    """Exclude contacts between bodies of one tree that overlap by design; return a note on them.

    These overlap in the rest pose, or they overlap in the motion qpos (T, nq) and are at most grandparent and
    grandchild.

    model  the compiled scene
    """
    at_rest = _overlaps(model, model.qpos0[None])
    on_the_way = _overlaps(model, qpos[spread(len(qpos))])
    pairs = sorted(at_rest | {pair for pair in on_the_way if _are_near(model, *pair)})
    for pair in pairs:
        _exclude(spec, *pair)
    if not pairs:
        return []
    names = list_names(f"{model.body(a).name}-{model.body(b).name}" for a, b in pairs)
    return [f"bodies that the model has in each other do not collide in the scene to simulate: {names}"]


def _overlaps(model: mujoco.MjModel, qpos: Array) -> set[tuple[int, int]]:
    """Return pairs of moving bodies of one tree that penetrate by more than `OVERLAP` in any pose (n, nq)."""
    data, out, least = mujoco.MjData(model), set[tuple[int, int]](), OVERLAP * size_of(model)
    moving = model.body_weldid != 0
    for row in qpos:
        data.qpos = row
        mujoco.mj_fwdPosition(model, data)
        for contact in data.contact:
            first, second = sorted(int(model.geom_bodyid[geom]) for geom in contact.geom)
            is_own = moving[first] and moving[second] and model.body_treeid[first] == model.body_treeid[second]
            if contact.dist < contact.includemargin - least and is_own:
                out.add((first, second))
    return out


def _are_near(model: mujoco.MjModel, first: int, second: int) -> bool:
    """Return whether one of two bodies is at most the other's grandparent; bodies welded together count as one."""

    def above(body: int) -> int:
        return int(model.body_weldid[model.body_parentid[model.body_weldid[body]]])

    bodies = {int(model.body_weldid[first]), int(model.body_weldid[second])}
    return any({body, other} == bodies for body in bodies for other in (above(body), above(above(body))))


def _exclude(spec: mujoco.MjSpec, first: int, second: int) -> None:
    bodies = list(spec.bodies)
    for body in (first, second):
        bodies[body].name = bodies[body].name or unique([f"body{body}"], [spec_body.name for spec_body in bodies])[0]
    spec.add_exclude(bodyname1=bodies[first].name, bodyname2=bodies[second].name)
