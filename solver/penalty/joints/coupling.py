"""Couplings of joints: equality constraints that make a hinge or slide a polynomial of another joint, or constant.

MuJoCo's q₁ − q₁⁰ = a₀ + a₁ (q₂ − q₂⁰) + … + a₄ (q₂ − q₂⁰)⁴ with the values at rest, for instance in grippers and double
knees. If all frames of a spline satisfy a coupling of degree one, so does the spline.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import mujoco
import numpy as np
from numpy.polynomial.polynomial import polyder, polyval

from ...array import Array, Index
from ...figure.figure import Figure, JointKind
from ...figure.kinematics import Samples
from ..block import Block, Entries
from ..penalty import Normalization, Penalty


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
    normalization = Normalization(float(np.radians(1) ** 2), is_violation=True)

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
