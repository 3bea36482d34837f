"""Random models, robots, keyframes and samples."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import motions
import mujoco
import numpy as np
from figures import link_named
from hypothesis import strategies as st

from dynsplines.motion import Saved
from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.figure.figure import Figure, quaternion_columns
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.refine.subdivision import split

# Random models that mix all joints: several trees, several joints a body, bodies welded on, references off zero.

MOST_LINKS = 14
HINGE, SLIDE, BALL = mujoco.mjtJoint.mjJNT_HINGE, mujoco.mjtJoint.mjJNT_SLIDE, mujoco.mjtJoint.mjJNT_BALL
ON_A_BODY = ((), (HINGE,), (HINGE, HINGE), (SLIDE, HINGE), (BALL,), (BALL,), (BALL,), (SLIDE, BALL), (SLIDE, SLIDE))


def random_model(rng: np.random.Generator) -> mujoco.MjModel:
    """A model of a few trees; free joints only where MuJoCo has them, on bodies of the world."""
    return _random_spec(rng).compile()


def _random_spec(rng: np.random.Generator) -> mujoco.MjSpec:
    spec = mujoco.MjSpec()
    spec.option.gravity = rng.normal(size=3) * [1, 1, 9]
    spec.compiler.degree = False
    budget = int(rng.integers(3, MOST_LINKS))
    while budget > 0:
        budget = _grown(spec.worldbody, rng, budget, depth=0)
    return spec


def _grown(parent: mujoco.MjsBody, rng: np.random.Generator, budget: int, depth: int) -> int:
    """A body with its joints and children; returns how many joints are left to give."""
    body = parent.add_body(pos=rng.normal(size=3), quat=_turn(rng))
    body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=rng.uniform(0.05, 0.3, 3), pos=0.2 * rng.normal(size=3))
    if depth == 0 and rng.random() < 0.5:
        body.add_freejoint()
        budget -= 1
    else:
        for kind in ON_A_BODY[rng.integers(len(ON_A_BODY))]:
            where = 0.1 * rng.normal(size=3) if rng.random() < 0.5 else np.zeros(3)
            armature = 0.05 if rng.random() < 0.3 else 0.0
            joint = body.add_joint(type=kind, axis=_axis(rng), pos=where, armature=armature)
            if kind != BALL and rng.random() < 0.5:
                joint.ref = rng.normal()
            budget -= 1
    for _ in range(rng.integers(0, 3) if depth else 2):
        if budget > 0 and depth < 5:
            budget = _grown(body, rng, budget, depth + 1)
    return budget


def _turn(rng: np.random.Generator) -> np.ndarray:
    quat = rng.normal(size=4)
    return quat / np.linalg.norm(quat)


def _axis(rng: np.random.Generator) -> np.ndarray:
    axis = rng.normal(size=3)
    return axis / np.linalg.norm(axis)


def random_figure(seed: int, coordinates: str) -> tuple[Figure, np.random.Generator]:
    rng = np.random.default_rng(seed)
    model = random_model(rng)
    while model.njnt == 0:
        model = random_model(rng)
    return Figure(model, coordinates), rng


# Random robots as MJCF texts: joints of all kinds, frames in all notations, defaults, every passive force, options.
#
# Features are drawn by Hypothesis, which simplifies them; the numbers follow from a seed.

FEATURES = (
    "balls", "slides", "references", "limits", "springs", "dampers", "friction", "armature", "gravcomp", "fluid",
    "ellipsoids", "tendons", "couplings", "actuators", "frames", "inertial", "defaults", "flags", "gravity", "degrees",
    "collisions", "objects",
)  # fmt: skip
FLAGS = ("gravity", "frictionloss", "limit", "equality", "spring", "damper", "eulerdamp", "contact", "filterparent")
ORDERS = ("xyz", "zyx", "XYZ", "ZYX", "zxz", "YXY", "yZx")
FREE, BALL = mujoco.mjtJoint.mjJNT_FREE, mujoco.mjtJoint.mjJNT_BALL


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


def motion_of(path: str | Path, seed: int, spread: float = 0.6, count: int = 3, step: float = 0.2) -> Saved:
    """The spline through random poses: joints and root within `spread` of their reference [rad, m]."""
    model, rng = mujoco.MjModel.from_xml_path(str(path)), np.random.default_rng(seed)
    qpos = np.tile(model.qpos0, (count, 1))
    for row in qpos:
        mujoco.mj_integratePos(model, row, rng.uniform(-spread, spread, model.nv), 1.0)
    return motions.through(str(path), step * np.arange(count), qpos)


# Random keyframes, whole and partial, and how far a state is from one.

TIMES = [0.0, 0.4, 1.0, 1.3]


def blocks(figure: Figure) -> list[list[int]]:
    """The columns that are fixed together: quaternions whole, all others one by one."""
    quaternions = figure.tables.quaternion_columns.T.tolist()
    taken = {column for block in quaternions for column in block}
    return quaternions + [[column] for column in range(figure.width) if column not in taken]


def mask_without(figure: Figure, *names: str) -> np.ndarray:
    """Everything fixed but these joints; "root x", "root turn" for the parts of the first free root."""
    mask = np.ones(figure.width, bool)
    for name in names:
        if name.startswith("root "):
            mask[slice(3, 7) if name == "root turn" else "xyz".index(name[-1])] = False
            continue
        link = figure.links[link_named(figure, name) or 0]
        mask[quaternion_columns(link) or link.qpos] = False
    return mask


def random_keys(figure: Figure, rng: np.random.Generator, masks: dict[int, np.ndarray] | None = None) -> list[Frame]:
    """Keyframes with moderate steps and quaternions of any sign; what is left out holds zeros."""
    pose, keys = figure.to_qpos(figure.to_state(rng.normal(size=figure.width))), []
    for number, time in enumerate(TIMES):
        pose = pose + 0.25 * rng.normal(size=pose.shape)
        mask = (masks or {}).get(number, np.ones(figure.width, bool))
        qpos = pose.copy()
        for columns in figure.tables.quaternion_columns.T:
            qpos[columns] *= rng.choice([-1, 1])
        keys.append(Frame.key(time, np.where(mask, qpos, 0.0), mask))
    return keys


def distance_from_key(figure: Figure, state: np.ndarray, key: Frame) -> float:
    """The largest difference of a state's qpos from a key in the entries that it fixes, quaternions up to the sign."""
    qpos, apart = figure.to_qpos(state), [0.0]
    for block in blocks(figure):
        if not key.fixed[block].all():
            continue
        a, b = qpos[block], key.state[block]
        if len(block) == 4:
            b = quat.normalised(b)
            a = a * np.sign(a @ b)
        apart.append(float(np.abs(a - b).max()))
    return max(apart)


def masks_by_name(figure: Figure, name: str, rng: np.random.Generator) -> dict[int, np.ndarray]:
    first_joint = figure.links[2].name
    chosen = {
        "whole": {},
        "a joint free, what hangs on it fixed": {1: mask_without(figure, first_joint), 3: mask_without(figure, "root")},
        "root orientation free": {i: mask_without(figure, "root turn") for i in range(3)},
        "root position free on single axes": {
            0: mask_without(figure, "root x", "root z"),
            2: mask_without(figure, "root y"),
        },
    }
    if name in chosen:
        return chosen[name]
    masks = {}
    for i in range(4):
        mask = np.zeros(figure.width, bool)
        for block in blocks(figure):
            mask[block] = rng.random() < 0.5
        masks[i] = mask
    return masks


def partial_keys(figure: Figure, rng: np.random.Generator) -> list[Frame]:
    joint = figure.links[2].name
    return random_keys(figure, rng, {1: mask_without(figure, joint, "root x"), 2: mask_without(figure, "root turn")})


def closed(keys: list[Frame]) -> list[Frame]:
    return [*keys[:-1], Frame.key(TIMES[-1], keys[0].state, keys[0].fixed)]


def random_qpos(figure: Figure, rng: np.random.Generator) -> np.ndarray:
    return figure.to_qpos(figure.to_state(rng.normal(size=figure.width)))


# Random samples of a figure's motion, and what tests change in them.


def random_samples(figure: Figure, rng: np.random.Generator, count: int = 5) -> Samples:
    """States with quaternions well off unit length, and derivatives of every entry."""
    y = figure.to_state(rng.normal(size=(count, figure.width)))
    lengths = rng.uniform(0.7, 1.4, size=(count, figure.width))
    for columns in figure.tables.quaternion_columns.T:
        y[:, columns] *= lengths[:, columns[:1]]
    return Samples(figure, y, rng.normal(size=y.shape), 3 * rng.normal(size=y.shape))


def at_times(samples: Samples, t: np.ndarray) -> Samples:
    return Samples(samples.figure, samples.y, samples.y_d, samples.y_dd, t)


# Variable frames at equal distances.


def evenly(timeline: Timeline, count: int) -> Timeline:
    """The timeline with `count` variable frames at equal distances inside every segment."""
    times = timeline.times
    inner = times[:-1, None] + np.arange(1, count + 1) * (np.diff(times)[:, None] / (count + 1))
    return split(timeline, inner.ravel()) if count else timeline
