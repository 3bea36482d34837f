"""Equality constraints of a model: joints that follow others, and closed loops.

A coupling makes a hinge or slide a polynomial of another joint, or constant: MuJoCo's q₁ − q₁⁰ = a₀ + a₁ (q₂ − q₂⁰) + …
+ a₄ (q₂ − q₂⁰)⁴ with the values at rest, for instance in grippers and double knees. If all frames of a spline satisfy a
coupling of degree one, so does the spline.

A closed loop holds points of two bodies together. A connection holds one point of each body together. A weld holds
three, which are ARM apart, so that an error of rotation costs about as much as an error of position; it holds one if
its `torquescale` is zero.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import mujoco
import numpy as np
from numpy.polynomial.polynomial import polyder, polyval

from ... import quaternion as quat
from ...array import Array, Index
from ...contacts import Contact
from ...figure.figure import Figure, JointKind
from ...figure.kinematics import Samples
from ...surface.points import Point
from ..block import Block, Entries
from ..penalty import Normalization, Penalty, Role

UNTURNED = np.array([1.0, 0, 0, 0])
ARM = 0.1  # [m] distance from the middle of a weld to the points that hold its rotation


@dataclass(frozen=True, eq=False)
class Coupling:
    """A column of the state that follows another: follower − rest[0] = Σ coefficients (driver − rest[1])^k.

    Attributes:
        driver: The column of the driver; −1 for a constant follower.
        coefficients: The coefficients a₀ to a₄.
        unit: The unit of the follower, "degrees" or "m".
    """

    name: str
    follower: int
    driver: int
    rest: tuple[float, float]
    coefficients: Array
    unit: str

    def follow(self, driver: Array) -> Array:
        """Return the follower's values [rad or m] for the driver's."""
        return np.asarray(self.rest[0] + polyval(driver - self.rest[1], self.coefficients), float)

    def slope(self, driver: Array) -> Array:
        return np.asarray(polyval(driver - self.rest[1], polyder(self.coefficients)), float)


@dataclass(frozen=True)
class CouplingPenalty(Penalty):
    """Σ over couplings of the follower's squared deviation [rad² or m²]."""

    couplings: tuple[Coupling, ...]

    name = "coupled"
    role = Role.TARGET
    normalization = Normalization(float(np.radians(1) ** 2))

    @cached_property
    def _columns(self) -> tuple[Index, Index]:
        """Followers and drivers, (n,) each. A constant follower is its own driver, with a slope of zero."""
        followers = np.array([c.follower for c in self.couplings], np.intp)
        drivers = np.array([c.driver for c in self.couplings], np.intp)
        return followers, np.where(drivers < 0, followers, drivers)

    def away(self, samples: Samples) -> tuple[Array, Array]:
        """Return the deviations of followers, and their slopes, (n, S) each."""
        followers, drivers = self._columns
        driven = samples.columns(drivers)
        determined = np.array([c.follow(q) for c, q in zip(self.couplings, driven, strict=True)])
        slope = np.array([c.slope(q) for c, q in zip(self.couplings, driven, strict=True)])
        return samples.columns(followers) - determined, slope

    def residuals(self, samples: Samples) -> Iterator[Block]:
        followers, drivers = self._columns
        away, slope = self.away(samples)
        at = np.tile(np.arange(samples.count), len(self.couplings))
        follower, other = (np.repeat(columns, samples.count) for columns in (followers, drivers))
        yield Block(at, away.ravel(), (Entries(at, 0, follower), Entries(at, 0, other, -slope.ravel())))


def couplings(figure: Figure) -> tuple[Coupling, ...]:
    """Return the joint couplings among a model's active equality constraints."""
    model = figure.model
    chosen = (model.eq_type == int(mujoco.mjtEq.mjEQ_JOINT)) & (model.eq_active0 != 0)
    result = []
    for i in np.flatnonzero(chosen):
        one, two = int(model.eq_obj1id[i]), int(model.eq_obj2id[i])
        follower, driver = int(model.jnt_qposadr[one]), int(model.jnt_qposadr[two]) if two >= 0 else -1
        coefficients = np.array(model.eq_data[i, :5])
        if driver < 0:
            coefficients[1:] = 0
        rest = float(model.qpos0[follower]), float(model.qpos0[driver]) if two >= 0 else 0.0
        slides = model.jnt_type[one] == JointKind.SLIDE
        name = figure.links[one + 1].name
        result.append(Coupling(name, follower, driver, rest, coefficients, "m" if slides else "degrees"))
    return tuple(result)


def in_order(chosen: Sequence[Coupling]) -> list[Coupling]:
    """Return the couplings sorted so that a driver is computed before its followers, as far as possible."""
    remaining, done = list(chosen), []
    while remaining:
        followers = {c.follower for c in remaining}
        ready = [c for c in remaining if c.driver not in followers or c.driver == c.follower] or remaining[:1]
        done += ready
        remaining = [c for c in remaining if c not in ready]
    return done


def closures(figure: Figure) -> tuple[Contact, ...]:
    """Return the points that the active connections and welds of a model hold, except those of mocap bodies."""
    model, result = figure.model, []
    kinds = {int(mujoco.mjtEq.mjEQ_CONNECT): "connect", int(mujoco.mjtEq.mjEQ_WELD): "weld"}
    for i in np.flatnonzero(model.eq_active0 != 0):
        kind = kinds.get(int(model.eq_type[i]))
        if kind is None:
            continue
        frames = _frames(model, int(i), weld=kind == "weld")
        turns = kind == "weld" and model.eq_data[i, 10] > 0  # `torquescale`; zero leaves the rotation free
        if any(model.body_mocapid[body] >= 0 for body, _, _ in frames):
            continue
        name = model.equality(int(i)).name or " and ".join(model.body(body).name or "world" for body, _, _ in frames)
        offsets = [np.zeros(3), *(ARM * np.eye(3)[:2])] if turns else [np.zeros(3)]
        for offset in offsets:
            ends = []
            for body, position, turn in frames:
                link, place = figure.point_on_link(body, position + quat.rotate(turn, offset))
                ends.append(Point(name, link, place))
            if ends[0].link != ends[1].link:
                one, two = ends
                result.append(Contact.at(one, -np.inf, np.inf, two.position, on=two.link))
    return tuple(result)


def _frames(model: mujoco.MjModel, equality: int, *, weld: bool) -> list[tuple[int, Array, Array]]:
    """Return the two frames that must coincide: body, position in it (3,) [m] and rotation in it (4,)."""
    ids, data = (int(model.eq_obj1id[equality]), int(model.eq_obj2id[equality])), model.eq_data[equality]
    if int(model.eq_objtype[equality]) == int(mujoco.mjtObj.mjOBJ_SITE):
        return [(int(model.site_bodyid[s]), np.array(model.site_pos[s]), np.array(model.site_quat[s])) for s in ids]
    if not weld:
        return [(ids[0], np.array(data[:3]), UNTURNED), (ids[1], np.array(data[3:6]), UNTURNED)]
    # the anchor in the second body, the anchor in the first, and the rotation of the second in the first
    anchor, place, turn = np.array(data[:3]), np.array(data[3:6]), quat.normalise(np.array(data[6:10]))
    return [(ids[0], place, turn), (ids[1], anchor, UNTURNED)]
