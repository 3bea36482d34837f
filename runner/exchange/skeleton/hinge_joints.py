"""Ball joints as three hinges each, for formats and simulators with hinges only: model and motion, and back.

A ball joint `left_hip` becomes the hinges `left_hip_x`, `left_hip_z`, `left_hip_y`, in this order, about the axes of
the body at rest: R = R_x(a) R_z(b) R_y(c). Three hinges in series are in gimbal lock where the middle one is at ±90°.
Limbs lie along z, so the middle hinge is the twist about the limb, which has the smallest range. In eighteen motions,
which include cartwheels, hops and high kicks, it stayed within 85° and mostly below 50°; other orders reached 86° to
90°. Angles are continuous in time and exceed ±180° where the motion does. A motion through the lock passes it without
a jump.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import cached_property
from xml.etree import ElementTree

import mujoco
import numpy as np
from scipy.spatial.transform import Rotation

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import JointKind

from ...errors import UserError, words_of
from ...scene.assets import Scene

ORDER = "xzy"
NEAR = np.radians(10)  # [rad] largest distance from gimbal lock that is reported, as angles change fast near it
LOCKED = 1e-6  # cos b below which a and c are not unique
REFERRING = ("actuator", "sensor", "equality", "tendon")
ROTATION_ONLY = (
    "range", "ref", "springref", "axis", "limited", "type", "name", "actuatorfrcrange", "actuatorfrclimited",
)  # fmt: skip


def angles(rotation: Array, order: str = ORDER) -> Array:
    """Return angles (T, n, 3) [rad] in an order, continuous in time, of quaternions (T, n, 4) of any length > 0."""
    shape = (*rotation.shape[:-1], 3)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # in gimbal lock, the last angle is 0
        solved = Rotation.from_quat(rotation.reshape(-1, 4), scalar_first=True).as_euler(order.upper()).reshape(shape)
    is_locked = np.abs(np.cos(solved[..., 1])) < LOCKED
    parity = 1 if order in "xyzxy" else -1
    side = parity * np.sign(solved[..., 1])  # in gimbal lock, a + side * c determines the rotation
    out, before = np.zeros(shape), np.zeros(shape[1:])
    for t in range(len(out)):
        a, b, c = solved[t].T
        first = np.where(is_locked[t], before[:, 0], a)
        one = np.stack([first, b, np.where(is_locked[t], c + side[t] * (a - first), c)], -1)
        both = [_near(angle, before) for angle in (one, one * [1, -1, 1] + np.pi)]
        far = [np.abs(candidate - before).sum(-1) for candidate in both]
        before = out[t] = np.where((far[0] <= far[1])[:, None], *both)
    return out


def _near(angle: Array, other: Array) -> Array:
    """Shift an angle by whole turns to within half a turn of another."""
    return angle - 2 * np.pi * np.round((angle - other) / (2 * np.pi))


def rates(angle: Array, spin: Array, order: str = ORDER) -> Array:
    """Return rates (..., 3) [rad/s] of angles (..., 3) from the angular velocity (..., 3) in body axes.

    In gimbal lock some velocities are impossible; there the result is their least-squares approximation.
    """
    i, j, k = (np.eye(3)["xyz".index(letter)] for letter in order)
    last = quat.from_rotation_vector(-angle[..., 2, None] * k)
    middle = quat.from_rotation_vector(-angle[..., 1, None] * j)
    second = quat.rotated(last, j)
    first = quat.rotated(last, quat.rotated(middle, i))
    axes = np.stack([first, second, np.broadcast_to(k, second.shape)], -1)
    return (np.linalg.pinv(axes, rcond=LOCKED) @ spin[..., None])[..., 0]


@dataclass(frozen=True, eq=False)
class HingeLayout:
    """The joints of a model in qpos and qvel, and those of its variant with hinges."""

    model: mujoco.MjModel
    order: str = ORDER

    @cached_property
    def joints(self) -> list[tuple[int, tuple[str, ...]]]:
        model = self.model
        out = []
        for joint in range(model.njnt):
            name = model.joint(joint).name or f"joint{joint}"
            is_ball = model.jnt_type[joint] == JointKind.BALL
            out.append((joint, tuple(f"{name}_{axis}" for axis in self.order) if is_ball else (name,)))
        names = [name for _, hinges in out for name in hinges]
        twice = next((name for name in names if names.count(name) > 1), None)
        if twice is not None:
            raise UserError(f"with hinges for ball joints, the figure would have two joints '{twice}'")
        return out

    @property
    def names(self) -> list[str]:
        """The joints of the variant, in order."""
        return [name for _, hinges in self.joints for name in hinges]

    @cached_property
    def balls(self) -> list[int]:
        return [joint for joint, hinges in self.joints if len(hinges) == 3]

    def qpos(self, qpos: Array) -> Array:
        """Return configurations (T, nq') of the variant for configurations (T, nq) of the model."""
        if not self.balls:
            return np.array(qpos, float)
        rotation = np.stack([qpos[:, self._columns(joint)] for joint in self.balls], 1)
        angle = dict(zip(self.balls, np.moveaxis(angles(rotation, self.order), 1, 0), strict=True))
        return np.concatenate([angle.get(joint, qpos[:, self._columns(joint)]) for joint, _ in self.joints], 1)

    def qvel(self, hinges: Array, qvel: Array) -> Array:
        """Return velocities (T, nv') of the variant at `hinges` (T, nq') for velocities (T, nv) of the model."""
        out = []
        for (joint, names), start in zip(self.joints, self._starts, strict=True):
            dof = self.model.jnt_dofadr[joint]
            part = qvel[:, dof : dof + self._kind(joint).freedom]
            out.append(part if len(names) == 1 else rates(hinges[:, start : start + 3], part, self.order))
        return np.concatenate(out, 1)

    def back(self, hinges: Array) -> Array:
        """Return configurations (T, nq) of the model for those (T, nq') of the variant."""
        out = []
        for (joint, names), start in zip(self.joints, self._starts, strict=True):
            part = hinges[:, start : start + self._width(joint)]
            out.append(part if len(names) == 1 else quat.aligned(quat.from_euler(part, self.order)))
        return np.concatenate(out, 1)

    def at_rest(self, joint: int) -> Array:
        """Return the entries of a joint in the variant's qpos at the model's rest pose."""
        rest = self.model.qpos0[self._columns(joint)]
        return angles(rest[None, None], self.order)[0, 0] if joint in self.balls else np.array(rest)

    def nearest_lock(self, hinges: Array) -> tuple[float, str, int] | None:
        """Return the least distance [rad] from gimbal lock, its ball joint and sample; None without ball joints."""
        locks = []
        for (_, names), start in zip(self.joints, self._starts, strict=True):
            if len(names) == 3:
                off = np.abs(np.arcsin(np.clip(np.cos(hinges[:, start + 1]), -1, 1)))
                locks.append((float(off.min()), names[0][:-2], int(off.argmin())))
        return min(locks, default=None)

    def mjcf(self, text: str) -> str:
        """Return the variant's complete MJCF for the model's, without keyframes and references to ball joints.

        Each hinge has the ball joint's damping, stiffness and armature, and no range. Joints without a name get theirs
        from `names`, because MuJoCo numbers them otherwise in the variant.
        """
        root = ElementTree.fromstring(text)
        for keyframes in root.findall("keyframe"):
            root.remove(keyframes)
        if not self.balls:
            return ElementTree.tostring(root, encoding="unicode")
        world = root.find("worldbody")
        bodies = [] if world is None else list(world.iter("body"))
        if len(bodies) != self.model.nbody - 1:
            raise UserError("the model's text does not name its bodies one by one; hinges cannot be written into it")
        hinges_of = dict(self.joints)
        for body, element in enumerate(bodies, 1):
            first, count = self.model.body_jntadr[body], self.model.body_jntnum[body]
            written = [child for child in element if child.tag in ("joint", "freejoint")]
            if len(written) != count:
                raise UserError(f"the text of body '{self.model.body(body).name}' does not name its joints one by one")
            for joint, child in zip(range(first, first + count), written, strict=True):
                if len(hinges_of[joint]) == 3:
                    _replace(element, child, hinges_of[joint])
                elif child.tag == "joint" and not child.get("name"):
                    child.set("name", hinges_of[joint][0])
        _drop_references(root, {self.model.joint(joint).name for joint in self.balls})
        ElementTree.indent(root)
        return ElementTree.tostring(root, encoding="unicode")

    def _columns(self, joint: int) -> slice:
        start = self.model.jnt_qposadr[joint]
        return slice(start, start + self._kind(joint).width)

    def _kind(self, joint: int) -> JointKind:
        return JointKind(self.model.jnt_type[joint])

    def _width(self, joint: int) -> int:
        """Return the number of entries of a joint of the model in the variant's qpos."""
        return 3 if self._kind(joint) is JointKind.BALL else self._kind(joint).width

    @cached_property
    def _starts(self) -> list[int]:
        """The first column of every joint of the model in the variant's qpos."""
        return [0, *np.cumsum([self._width(joint) for joint, _ in self.joints[:-1]]).tolist()]


def _replace(body: ElementTree.Element, ball: ElementTree.Element, names: tuple[str, ...]) -> None:
    place = list(body).index(ball)
    body.remove(ball)
    attributes = {key: value for key, value in ball.attrib.items() if key not in ROTATION_ONLY}
    for n, name in enumerate(names):
        axis = " ".join("1" if letter == name[-1] else "0" for letter in "xyz")
        hinge = {"name": name, "type": "hinge", "axis": axis, "ref": "0", "limited": "false"}
        body.insert(place + n, ElementTree.Element("joint", hinge | attributes))


def _drop_references(root: ElementTree.Element, balls: set[str]) -> None:
    """Remove actuators, sensors and constraints of the replaced joints."""
    for section in (element for tag in REFERRING for element in root.findall(tag)):
        for child in list(section):
            named = {
                element.get(key) for element in child.iter() for key in ("joint", "joint1", "joint2", "jointinparent")
            }
            if balls & named:
                section.remove(child)


@dataclass(frozen=True, eq=False)
class HingeModel:
    """A motion of a model with hinges only: qpos (T, nq), qvel (T, nv); mjcf is the complete model."""

    layout: HingeLayout
    mjcf: str
    model: mujoco.MjModel
    qpos: Array
    qvel: Array

    @classmethod
    def of(cls, model: mujoco.MjModel, scene: Scene, qpos: Array, qvel: Array) -> HingeModel:
        """Return the variant of a model with its motion, unchanged without ball joints; scene is the complete model."""
        layout, mjcf = HingeLayout(model), scene.mjcf
        hinges = layout.qpos(qpos)
        if not layout.balls:
            return cls(layout, mjcf, model, hinges, qvel)
        text = layout.mjcf(mjcf)
        try:
            variant = Scene(text, scene.assets).model()
        except ValueError as error:
            raise UserError(f"the figure with hinges for ball joints: {words_of(error)}") from None
        return cls(layout, text, variant, hinges, layout.qvel(hinges, qvel))

    @property
    def is_other(self) -> bool:
        return bool(self.layout.balls)

    def warning(self, time: Array) -> str | None:
        """Return a note if the motion comes close to gimbal lock."""
        lock = self.layout.nearest_lock(self.qpos)
        if lock is None or lock[0] > NEAR:
            return None
        off, name, sample = lock
        return (
            f"'{name}' comes within {np.degrees(off):.0f}° of gimbal lock at {time[sample]:.2f} s: "
            "its three hinges turn fast there"
        )
