"""Random robots through export, import and simulation, each compared with MuJoCo's results on the user's own file."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass, field
from pathlib import Path

import motions
import mujoco
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from motions import exported_scene as exported
from motions import played
from oracles import inverse_dynamics
from random_models import motion_of

from dynsplines.errors import UserError
from dynsplines.exchange import quantities
from dynsplines.measure.forces import Forces
from dynsplines.motion import Sampled, Saved
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Mask

WITHIN = 0.05  # [rad], [m]
EXACT = 1e-6  # [m], [rad]
EVERY = ("csv", "npz", "mjcf")
ROBOTICS = ("mjlab", "mjlab-csv", "locomujoco", "gmr")
FREE, SLIDE = int(mujoco.mjtJoint.mjJNT_FREE), int(mujoco.mjtJoint.mjJNT_SLIDE)

# Features of robots are drawn by Hypothesis, which simplifies them; the numbers follow from a seed.

FEATURES = (
    "balls", "slides", "references", "limits", "springs", "dampers", "friction", "armature", "gravcomp", "fluid",
    "ellipsoids", "tendons", "couplings", "actuators", "frames", "inertial", "defaults", "flags", "gravity", "degrees",
    "collisions", "objects",
)  # fmt: skip
FLAGS = ("gravity", "frictionloss", "limit", "equality", "spring", "damper", "eulerdamp", "contact", "filterparent")
ORDERS = ("xyz", "zyx", "XYZ", "ZYX", "zxz", "YXY", "yZx")


@dataclass
class RandomRobot:
    """A robot with one tree, which objects may be beside.

    root      'free', 'fixed', 'planar' (two slides and a hinge) or 'carriage' (three slides and a ball)
    features  those of `FEATURES` that it has
    seed      of all numbers
    """

    root: str
    features: frozenset[str]
    seed: int
    joints: list[str] = field(default_factory=list)  # the names of hinges and slides
    bodies: int = 0

    @property
    def is_single(self) -> bool:
        """Whether every body of the tree has a hinge or a ball joint at most, as a character of MimicKit."""
        return "slides" not in self.features

    def mjcf(self) -> str:
        """The text of the model, which compiles."""
        self.rng, self.joints, self.bodies, self.count = np.random.default_rng(self.seed), [], 0, 0
        tree = self._body(0)
        beside = [f'<body name="post" pos="0 3 0">{self._geom()}</body>', tree]
        if self.has("objects"):
            free = f'<body name="object" pos="3 0 1">{self._joint("free")}<geom size=".1" mass=".2"/></body>'
            door = f'<body name="door" pos="-3 0 1">{self._joint("hinge")}{self._geom()}</body>'
            beside = [door, *beside, free][:: int(self.rng.choice([-1, 1]))]
        order = self.rng.choice(ORDERS)
        angle = "degree" if self.has("degrees") else "radian"
        return (
            f'<mujoco><compiler angle="{angle}" eulerseq="{order}" {self._compiler()}/>{self._option()}'
            f"{self._defaults()}<worldbody>{''.join(beside)}</worldbody>{self._rest()}</mujoco>"
        )

    def has(self, feature: str) -> bool:
        return feature in self.features

    def _if(self, feature: str, text: str, share: float = 0.6) -> str:
        """A text with a probability if the robot has a feature."""
        return text if self.has(feature) and self.rng.random() < share else ""

    def _numbers(self, count: int, scale: float = 1.0) -> str:
        return " ".join(f"{x:.4f}" for x in scale * self.rng.normal(size=count))

    def _angles(self, *radians: float) -> str:
        return " ".join(f"{np.degrees(x) if self.has('degrees') else x:.4f}" for x in radians)

    def _rotation(self) -> str:
        notations = {
            "quat": self._numbers(4),
            "euler": self._angles(*self.rng.uniform(-3, 3, 3)),
            "axisangle": f"{self._numbers(3)} {self._angles(self.rng.uniform(-3, 3))}",
            "xyaxes": self._numbers(6),
            "zaxis": self._numbers(3),
        }
        name = self.rng.choice(list(notations))
        return f'{name}="{notations[name]}"'

    def _compiler(self) -> str:
        return self._if("inertial", 'settotalmass="12"', 0.3)

    def _option(self) -> str:
        words = self._if("gravity", f'gravity="{self._numbers(3, 5.0)}"', 1.0)
        words += self._if("fluid", f' density="80" viscosity=".3" wind="{self._numbers(3)}"', 1.0)
        words += self._if("flags", f' integrator="{self.rng.choice(["Euler", "RK4", "implicit"])}"')
        flags = self._if("flags", f'<flag {self.rng.choice(FLAGS)}="disable"/>', 1.0)
        return f"<option {words}>{flags}</option>"

    def _defaults(self) -> str:
        joint = '<joint damping="1.5" stiffness="3" armature=".02" frictionloss=".2"/>'
        words = f'{joint}<geom density="700"/><motor ctrlrange="-.1 .1" gear="7"/>'
        nested = '<default class="limb"><joint damping=".3" springdamper="0 0"/><geom density="1500" rgba="1 0 0 1"/>'
        nested += '<position kp="3" ctrlrange="-.2 .2"/></default>'
        return f"<default>{words}{nested}</default>" if self.has("defaults") else ""

    def _name(self, prefix: str) -> str:
        """A unique name, in no order; of a body or a joint without one, nothing."""
        self.count += 1
        return f"{prefix}{(self.count * 7919) % 1009}"

    def _joint(self, kind: str) -> str:
        name = self._name("j")
        words = f'<joint name="{name}" type="{kind}"'
        words += self._if("dampers", f' damping="{self.rng.uniform(0, 3):.4f}"')
        words += self._if("friction", f' frictionloss="{self.rng.uniform(0, 2):.4f}"')
        words += self._if("armature", f' armature="{self.rng.uniform(0, 0.3):.4f}"')
        if kind == "free":
            return words + "/>"
        words += self._if("springs", f' stiffness="{self.rng.uniform(0, 30):.4f}"')
        words += self._if("frames", f' pos="{self._numbers(3, 0.05)}"')
        if kind == "ball":
            return words + self._if("limits", f' limited="true" range="0 {self._angles(1.5)}"') + "/>"
        self.joints.append(name)
        number = self._angles if kind == "hinge" else lambda *x: " ".join(f"{0.3 * each:.4f}" for each in x)
        words += f' axis="{self._numbers(3)}"'
        words += self._if("references", f' ref="{number(self.rng.normal())}"')
        words += self._if("springs", f' springref="{number(self.rng.normal())}"')
        words += self._if("limits", f' limited="true" range="{number(-0.7, 0.9)}"')
        words += self._if("actuators", ' actuatorfrcrange="-2 2" actuatorgravcomp="true"', 0.4)
        return words + "/>"

    def _joints(self, depth: int) -> str:
        if depth == 0:
            kinds = {"free": ["free"], "fixed": [], "planar": ["slide", "slide", "hinge"]}
            return "".join(map(self._joint, kinds.get(self.root, ["slide", "slide", "slide", "ball"])))
        kinds = ["ball" if self.has("balls") and self.rng.random() < 0.4 else "hinge"]
        if self.has("slides"):
            kinds = [kinds, ["slide", "hinge"], ["hinge", "hinge"], ["slide"]][self.rng.integers(4)]
        return "".join(map(self._joint, kinds))

    def _geom(self) -> str:
        kinds = {
            "sphere": f'size="{self.rng.uniform(0.02, 0.06):.4f}"',
            "capsule": f'size=".03" fromto="0 0 0 {self._numbers(3, 0.1)}"',
            "box": 'size=".06 .04 .02" ' + self._rotation(),
            "ellipsoid": 'size=".06 .04 .05"',
            "cylinder": 'size=".03 .07" ' + self._rotation(),
        }
        kind = self.rng.choice(list(kinds))
        place = "" if kind == "capsule" else f'pos="{self._numbers(3, 0.03)}"'
        shape = self._if("ellipsoids", 'fluidshape="ellipsoid"')
        bits = "" if self.has("collisions") else 'contype="0" conaffinity="0"'
        return f'<geom type="{kind}" {kinds[kind]} {place} {shape} {bits}/>'

    def _inertial(self) -> str:
        if not self._if("inertial", "inertial"):
            return ""
        mass, place = self.rng.uniform(0.3, 3), f'pos="{self._numbers(3, 0.05)}"'
        if self.rng.random() < 0.5:
            return f'<inertial mass="{mass:.4f}" {place} fullinertia=".02 .03 .025 .002 -.001 .003"/>'
        return f'<inertial mass="{mass:.4f}" {place} {self._rotation()} diaginertia=".02 .03 .025"/>'

    def _body(self, depth: int) -> str:
        number = self.bodies
        self.bodies += 1
        place = self._numbers(3, 0.15) if depth else "0 0 1"
        words = f'<body name="b{number}" pos="{place}"'
        words += self._if("frames", " " + self._rotation()) + self._if("gravcomp", ' gravcomp=".7"')
        words += self._if("defaults", ' childclass="limb"', 0.4)
        inside = self._joints(depth) + self._inertial() + f'{self._geom()}<site name="s{number}" pos=".05 .02 0"/>'
        below = "".join(self._body(depth + 1) for _ in range(self.rng.integers(1, 3) if depth < 2 else 0))
        if depth and self._if("frames", "frame", 0.3):
            below = f'<frame pos="{self._numbers(3, 0.1)}" {self._rotation()}>{below}</frame>'
        return f"{words}>{inside}{below}</body>"

    def _force(self) -> str:
        words = self._if("springs", f' stiffness="{self.rng.uniform(0, 60):.4f}" springlength=".1 .3"')
        return words + self._if("dampers", ' damping="2"') + self._if("friction", ' frictionloss="1.5"')

    def _rest(self) -> str:
        """Tendons, equality constraints and actuators."""
        out, joints = "", self.joints
        if self.has("tendons"):
            out += f'<tendon><spatial name="rope" {self._force()}><site site="s0"/><site site="s{self.bodies - 1}"/>'
            out += "</spatial>"
            if joints:
                out += f'<fixed name="gear" {self._force()}><joint joint="{joints[0]}" coef=".7"/>'
                out += f'<joint joint="{joints[-1]}" coef="-.4"/></fixed>' if len(joints) > 1 else "</fixed>"
            out += "</tendon>"
        if self.has("couplings") and len(joints) > 1:
            pair = f'joint1="{joints[0]}" joint2="{joints[-1]}"'
            out += f'<equality><joint {pair} polycoef=".1 .5 0 0 0"/></equality>'
        if self.has("actuators") and joints:
            motors = f'<motor name="m" joint="{joints[0]}" gear="30"/><position joint="{joints[-1]}" kp="5" kv="1"/>'
            out += f'<actuator>{motors}</actuator><sensor><actuatorfrc actuator="m"/></sensor>'
        return out


@st.composite
def robots(draw: st.DrawFn) -> RandomRobot:
    """Robots of few to many features."""
    root = draw(st.sampled_from(["fixed", "free", "planar", "carriage"]))
    features = draw(st.sets(st.sampled_from(FEATURES)))
    return RandomRobot(root, frozenset(features), draw(st.integers(0, 10**6)))


def assert_close(actual: Array, expected: Array) -> None:
    """To 1e-6 of the largest value."""
    np.testing.assert_allclose(actual, expected, rtol=0, atol=EXACT * np.abs(expected).max(initial=1e-9))


def borne(forces: Forces) -> Mask:
    """(T,) whether the ground gives forces."""
    return np.any([np.any(foot.force != 0, axis=1) for foot in forces.feet], axis=0)


def check_forces(saved: Saved, expected: Array) -> None:
    """Torques, and the root's wrench about the centre of mass, are those of mj_inverse."""
    forces, at, model = Forces.of(Sampled.of(saved)), motions.samples(saved), saved.figure.model
    rows = forces.has_known_support & ~borne(forces)
    np.testing.assert_allclose(forces.torques[rows], expected[rows], rtol=0, atol=EXACT * np.abs(expected).max())
    root = saved.figure.root
    if root is None:
        with pytest.raises(UserError, match="no free root"):
            quantities.table(Sampled.of(saved), ("wrench",))
        return
    columns = quantities.wrench(forces)
    force, moment, centre = np.array(list(columns.values())).reshape(3, 3, -1).transpose(0, 2, 1)
    q, dof, data = int(model.jnt_qposadr[root.joint]), int(model.jnt_dofadr[root.joint]), mujoco.MjData(model)
    for qpos, row in zip(at.qpos, centre, strict=True):
        data.qpos = qpos
        mujoco.mj_fwdPosition(model, data)
        np.testing.assert_allclose(row, data.subtree_com[root.body], atol=EXACT)
    assert_close(force, expected[:, dof : dof + 3])
    turned = quat.rotated(at.qpos[:, q + 3 : q + 7], expected[:, dof + 3 : dof + 6])
    assert_close(moment, turned - np.cross(centre - at.qpos[:, q : q + 3], force))


def carriers(robot: RandomRobot) -> tuple[str, ...]:
    """The formats that can hold the motion of a robot."""
    is_alone = robot.root == "free" and not robot.has("objects")
    single = ("mimickit",) if is_alone and robot.is_single else ()
    return (*EVERY, *(ROBOTICS if is_alone and not robot.has("balls") else ()), *single)


def check_feed_forward(model: mujoco.MjModel, expected: Array, rows: Mask) -> None:
    """At keys without ground reactions the actuators exert the forces of mj_inverse, at all joints but free ones."""
    data, forces = mujoco.MjData(model), []
    for key in range(model.nkey):
        mujoco.mj_resetDataKeyframe(model, data, key)
        mujoco.mj_forward(model, data)
        forces.append(data.qfrc_actuator.copy())
    driven = model.jnt_type[model.dof_jntid] != FREE
    assert np.abs(np.array(forces) - expected)[np.ix_(rows, driven)].max(initial=0) <= EXACT * np.abs(expected).max()


def largest_errors(model: mujoco.MjModel) -> tuple[float, float]:
    """How far `mj_step` leaves the keys in a second: [rad] and [m]."""
    worst = played(model, 1.0).worst
    is_length = model.jnt_type[model.dof_jntid] == SLIDE
    for joint in np.flatnonzero(model.jnt_type == FREE):
        is_length[model.jnt_dofadr[joint] + np.arange(3)] = True
    return worst[~is_length].max(initial=0), worst[is_length].max(initial=0)


def check_simulation(saved: Saved, folder: Path, expected: Array) -> None:
    """The scene follows the motion, or a note says that it does not."""
    model, notes = exported(saved, folder)
    forces = Forces.of(Sampled.of(saved))
    check_feed_forward(model, expected, forces.has_known_support & ~borne(forces))
    angle, length = largest_errors(model)
    line = next(note for note in notes if note.startswith("mj_step of the scene"))
    assert ("stays within" in line) == (angle < WITHIN and length < WITHIN), (line, angle, length)


@pytest.mark.slow
@settings(max_examples=4, deadline=None, database=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
@given(robot=robots(), spread=st.sampled_from([0.1, 0.6]))
def test_random_robots_are_exported_imported_and_simulated_as_mujoco_computes(robot: RandomRobot, spread: float):
    with tempfile.TemporaryDirectory() as name:
        folder, figure = Path(name), Path(name) / "robot.xml"
        figure.write_text(robot.mjcf())
        model, saved = mujoco.MjModel.from_xml_path(str(figure)), motion_of(figure, robot.seed, spread)
        check_forces(saved, inverse_dynamics(model, motions.samples(saved)))
        for kind in carriers(robot):
            target, _ = motions.exported(saved, kind, folder)
            motions.came_back(saved, target, str(figure), EXACT, kind=kind, fps=saved.fps)
        model.jnt_actgravcomp[:] = 0  # the scene compensates gravity without actuators
        check_simulation(saved, folder, inverse_dynamics(model, motions.samples(saved)))
