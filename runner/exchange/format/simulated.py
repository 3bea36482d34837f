"""A scene that stands by itself under `mj_step`: soles and body collide with it, every joint has position actuators.

The figure's own geoms that collide go on doing so, all of them if none does, and what is solid in the scene meets them.
A figure whose geoms were for the eye alone still does not meet itself. Actuators that a model has are replaced:

    force = kp (ctrl − q) − kv q'            hinges and slides; a ball joint has three, about its x, y and z

with q the joint's coordinate, for a ball joint its rotation vector. `ctrl` of a key is q + (kv q' + τ) / kp of the
motion, τ the torque that moves it so (`forces`): on the motion the actuators give just τ, and off it they pull back.
The gains:

    kp = m ω², ω = 2π · 8 Hz, m the joint's inertia at rest (of a ball joint the largest), and for the joints of limbs
         that stand at least 0.7 / rad of weight times height (a slide: as if 0.1 m were a radian): they bear it all
    kv = kp · 0.04 s, which is critical damping, 2 / ω

A free root has no actuator. Gains are in N m/rad and N m s/rad, of slides in N/m and N s/m.
"""

from __future__ import annotations

from dataclasses import dataclass
from xml.etree import ElementTree

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.figure import wrench
from dynsplines.solver.figure.figure import Figure

from ...clip import load as clip
from ...measure.penetration import moving_geoms, solid_geoms
from ...scene.mujoco_versions import geoms_by_number, portable_text
from ..forces import Forces
from ..take import Take

FREQUENCY = 8.0  # [Hz] at which a limb held by its actuators would swing: several times what people do
DAMPING = 2 / (2 * np.pi * FREQUENCY)  # [s] kv / kp of critical damping
STANDING = 0.7  # [1/rad] of weight times height: one limb holds an upright figure, which falls by 0.55; more bounces
SLIDE = 0.1  # [m] by which a slide may give where a hinge gives a radian
TIMESTEP = 0.002  # [s] at most
SOFTNESS = (0.01, 1.5)  # time constant [s] and damping of contacts: feet land without bouncing
IMPEDANCE = 10.0  # of friction beside that of normal forces: standing feet do not creep
ALL = 1  # the bit by which geoms that were for the eye meet what is solid
BALL, FREE, HINGE = (
    int(kind) for kind in (mujoco.mjtJoint.mjJNT_BALL, mujoco.mjtJoint.mjJNT_FREE, mujoco.mjtJoint.mjJNT_HINGE)
)


@dataclass(frozen=True)
class Drive:
    """A position actuator: its joint, the axis of a ball joint that it turns about or None, and its gains."""

    name: str
    joint: int
    axis: int | None
    kp: float
    kv: float


def drives(take: Take) -> list[Drive]:
    """The actuators of a figure, joint after joint."""
    model, least = take.model, _least(take)
    out = []
    for joint in range(model.njnt):
        kind, dof = int(model.jnt_type[joint]), int(model.jnt_dofadr[joint])
        if kind == FREE:
            continue
        inertia = float(model.dof_M0[dof : dof + (3 if kind == BALL else 1)].max())
        kp = _rounded(max(inertia * (2 * np.pi * FREQUENCY) ** 2, least[joint]))
        name, kv = joint_name(model, joint), _rounded(kp * DAMPING)
        if kind == BALL:
            out += [Drive(f"{name}_{letter}", joint, axis, kp, kv) for axis, letter in enumerate("xyz")]
        else:
            out.append(Drive(name, joint, None, kp, kv))
    return out


def joint_name(model: mujoco.MjModel, joint: int) -> str:
    """A joint's name, which one without gets here."""
    return model.joint(joint).name or f"joint{joint}"


def _rounded(gain: float) -> float:
    """To three digits: gains are to be read."""
    return float(f"{gain:.3g}")


def _least(take: Take) -> Array:
    """(njnt,) the gain that holds all of the figure, for joints between a free root and the soles that it stands on."""
    figure, model = take.figure, take.model
    out = np.zeros(model.njnt)
    problem = clip.answered(take.saved)
    if problem.context.support is None or not problem.context.points:
        return out
    root = problem.context.support.root
    gain = STANDING * wrench.weight(figure, root) * wrench.height(figure, root)
    for link in _standing(figure, {point.link for point in problem.context.points}):
        joint = int(np.searchsorted(model.jnt_qposadr, figure.links[link].qpos))
        hinged = int(model.jnt_type[joint]) in (BALL, HINGE)
        out[joint] = gain if hinged else gain / SLIDE**2
    return out


def _standing(figure: Figure, feet: set[int]) -> set[int]:
    """The links from the feet up to the free root, without it."""
    out: set[int] = set()
    for foot in feet:
        link = foot
        while link > 0 and figure.links[link].kind is not figure.links[link].kind.FREE:
            out.add(link)
            link = figure.links[link].parent
    return out


def targets(take: Take, actuators: list[Drive]) -> Array:
    """(T, nu) what `ctrl` is at the samples. Where no torque is known, position and velocity alone."""
    model, torques = take.model, np.nan_to_num(Forces.of(take).torques)
    out = np.zeros((len(take.qpos), len(actuators)))
    for column, drive in enumerate(actuators):
        first, dof = int(model.jnt_qposadr[drive.joint]), int(model.jnt_dofadr[drive.joint])
        if drive.axis is None:
            at = take.qpos[:, first]
        else:
            at = _rotation_vectors(take.qpos[:, first : first + 4])[:, drive.axis]
            dof += drive.axis
        out[:, column] = at + (drive.kv * take.qvel[:, dof] + torques[:, dof]) / drive.kp
    return out


def _rotation_vectors(quaternions: Array) -> Array:
    """(T, 3) [rad] of unit quaternions (T, 4), half a turn at most."""
    out = np.zeros((len(quaternions), 3))
    for row, quaternion in zip(out, quaternions, strict=True):
        mujoco.mju_quat2Vel(row, quaternion, 1.0)
    return out


def scene(take: Take, actuators: list[Drive]) -> ElementTree.Element:
    """The model's text with geoms that collide, and the actuators."""
    spec = take.saved.scene.spec()
    model = take.model
    _collide(spec, model)
    for number, joint in enumerate(spec.joints):
        joint.name = joint_name(model, number)
    spec.option.timestep = min(float(model.opt.timestep), TIMESTEP)
    spec.option.integrator = int(mujoco.mjtIntegrator.mjINT_IMPLICITFAST)  # or stiff damping makes it explode
    spec.option.cone = int(mujoco.mjtCone.mjCONE_ELLIPTIC)
    spec.option.impratio = max(float(model.opt.impratio), IMPEDANCE)
    spec.compile()
    root = ElementTree.fromstring(portable_text(spec))
    for section in root.findall("actuator"):
        root.remove(section)
    for sensors in root.findall("sensor"):
        for sensor in [each for each in sensors if "actuator" in each.attrib]:
            sensors.remove(sensor)
    section = ElementTree.SubElement(root, "actuator")
    for drive in actuators:
        values = {"name": drive.name, "joint": joint_name(model, drive.joint), "kp": f"{drive.kp:g}"}
        values["kv"] = f"{drive.kv:g}"
        if drive.axis is not None:
            values["gear"] = " ".join("1" if axis == drive.axis else "0" for axis in range(3))
        ElementTree.SubElement(section, "position", values)
    return root


def _collide(spec: mujoco.MjSpec, model: mujoco.MjModel) -> None:
    """Lets the figure and what is solid around it meet."""
    geoms = geoms_by_number(spec)
    movers, solids = list(moving_geoms(model)), list(solid_geoms(model))
    if not any(geoms[i].contype or geoms[i].conaffinity for i in movers):
        for i in movers:
            geoms[i].contype, geoms[i].conaffinity = ALL, 0
            geoms[i].solref[:2] = SOFTNESS
    types, affinities = ALL, ALL
    for i in movers:
        types, affinities = types | geoms[i].contype, affinities | geoms[i].conaffinity
    for i in solids:
        geoms[i].contype, geoms[i].conaffinity = affinities, types
        geoms[i].solref[:2] = SOFTNESS
