"""Sets of orientations for one ball joint, our solutions through them, and every curve's energy, measured alike."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import exact_path
import numpy as np
from numpy.typing import NDArray
from paper.orientations import INTRINSIC, moderate, spinner

from dynsplines.solver import Frame, Objective, Path, Problem, Quadrature, Settings, Solution, inbetween
from dynsplines.solver import quaternion as quat
from dynsplines.solver.penalty import CovariantAcceleration, UnitMagnitude

Array = NDArray[np.float64]

LIGHT = ((CovariantAcceleration(), 5.0), (UnitMagnitude(), 0.25))
ENERGY = ((CovariantAcceleration(), 1.0),)
FINE = Quadrature("gauss", 8, 0.05)
OTHER_CLASS = 0.05
CLOSED, NEWTON_STEPS = 1e-10, 25
LEAST_GAIN, MOST_WASTED = 0.5, 2


def uniform(rng: np.random.Generator, count: int) -> Array:
    """(count, 4) uniformly random orientations, by shortest arcs."""
    return quat.align_signs(quat.normalise(rng.normal(size=(count, 4))))


KINDS: dict[str, Callable[[np.random.Generator, int], Array]] = {"moderate": moderate, "random": uniform}


def uneven_times(rng: np.random.Generator, count: int, ratio: float) -> Array:
    """(count,) times [s], intervals log-uniform between 1 and `ratio`, their mean 1 s."""
    steps = ratio ** rng.uniform(size=count - 1)
    return np.concatenate([[0.0], np.cumsum(steps / steps.mean())])


@dataclass(frozen=True, eq=False)
class Track:
    """Keyframes of one set: times (K,) [s] and unit quaternions (K, 4)."""

    kind: str
    seed: int
    times: Array
    orientations: Array

    @property
    def name(self) -> str:
        return f"{self.kind} {self.seed}"

    @property
    def keys(self) -> list[Frame]:
        return [Frame.key(t, q) for t, q in zip(self.times, self.orientations, strict=True)]


def track(kind: str, seed: int, count: int, ratio: float | None = None) -> Track:
    """Set `seed` of a kind: 1 s apart, or uneven by up to `ratio` : 1."""
    rng = np.random.default_rng(seed)
    orientations = KINDS[kind](rng, count)
    times = np.arange(float(count)) if ratio is None else uneven_times(rng, count, ratio)
    return Track(kind, seed, times, orientations)


def solved(
    track: Track, settings: Settings, improved: Callable[[Any], None] | None = None, *, light: bool = False
) -> Solution:
    """Our path through a set, in the intrinsic form; `light`: with a weak unit term, which lets |q| vary more."""
    return inbetween(Problem(spinner(), track.keys, LIGHT if light else INTRINSIC, settings), improved=improved)


def energy(path: Path) -> float:
    """¼ ∫ |ω'|² dt of the normalised path, 8 Gauss points on panels of at most 50 ms between knots."""
    return Objective.of(spinner(), ENERGY, quadrature=FINE).value(path)


def acceleration_energy(times: Array, acceleration: Callable[[Array], Array]) -> float:
    """¼ ∫ |ω'|² dt of any curve that gives ω' (S, 3) at times (S,) and is smooth between its keyframes."""
    t, w = FINE.nodes(times)
    return float(0.25 * w @ np.sum(acceleration(t) ** 2, axis=1))


def sampled_energy(times: Array, orientation: Callable[[Array], Array], steps: int = 400) -> float:
    """The same for a curve of unit quaternions only, by central differences within every segment."""
    total = 0.0
    for a, b in pairwise(times):
        h = (b - a) / steps
        q = quat.align_signs(orientation(np.linspace(a, b, steps + 1)))
        middle, second = q[1:-1], (q[2:] - 2 * q[1:-1] + q[:-2]) / h**2
        density = np.sum((second - np.sum(second * middle, axis=1, keepdims=True) * middle) ** 2, axis=1)
        total += h * (density.sum() + 0.5 * (density[0] + density[-1]))
    return total


def exact_energy(track: Track) -> float | None:
    """The exact minimiser's energy, or None where its Newton iteration does not close from the natural cubic."""
    keys = quat.align_signs(track.orientations)
    with np.errstate(all="ignore"):
        return _closed_energy(track.times, keys, exact_path._start(track.times, keys))


def exact_energy_from(track: Track, path: Path) -> float | None:
    """The same from the rates of our path: the exact path in its winding class."""
    keys = quat.normalise(path.at(track.times))
    with np.errstate(all="ignore"):
        return _closed_energy(track.times, keys, np.array([_rates(path, a, b) for a, b in pairwise(track.times)]))


def _closed_energy(times: Array, keys: Array, states: Array) -> float | None:
    """The exact path's Newton iteration with its line search; None where it does not close.

    It is given up after 25 steps, or when two in succession leave more than half of the gap: those that close take
    about five, most of them whole.
    """
    gap = exact_path._gaps(times, keys, states)
    wasted = 0
    for _ in range(NEWTON_STEPS):
        if np.linalg.norm(gap) < CLOSED or wasted == MOST_WASTED:
            break
        try:
            step = np.asarray(np.linalg.solve(exact_path._jacobian(times, keys, states), -gap), float)
        except np.linalg.LinAlgError:
            return None
        closer = exact_path._shortened(times, keys, states, step.reshape(states.shape))
        if closer is None:
            return None
        wasted = wasted + 1 if np.linalg.norm(closer[1]) > LEAST_GAIN * np.linalg.norm(gap) else 0
        states, gap = closer
    if np.linalg.norm(gap) >= CLOSED:
        return None
    value = exact_path.ExactPath(times, keys, states).energy
    return float(value) if np.isfinite(value) else None


def _rates(path: Path, a: float, b: float) -> Array:
    """(9,) the body's ω, ω', ω'' just after a; ω'' from all of the segment to b: seen from the world it is constant.

    With the world's Ω that is Ω'' − Ω × Ω', whose mean takes no third derivative.
    """
    t, w = FINE.nodes(np.unique(np.clip(path.spline.times, a, b)))
    (omega, omega_d), (ends, ends_d) = (_world_rates(path, times) for times in (t, np.array([a, b])))
    constant = (ends_d[1] - ends_d[0] - w @ np.cross(omega, omega_d)) / (b - a)
    return quat.rotate(quat.inverse(path.at(np.array([a]))), np.array([ends[0], ends_d[0], constant])).ravel()


def _world_rates(path: Path, t: Array) -> tuple[Array, Array]:
    """Ω and Ω' (S, 3) at times t (S,)."""
    q, q_d, q_dd = (path.at(t, order) for order in range(3))
    inverse = quat.inverse(q)
    rate = quat.product(q_d, inverse)
    return 2 * rate[..., 1:], 2 * (quat.product(q_dd, inverse) - quat.product(rate, rate))[..., 1:]


def in_other_class(ratio: float) -> bool:
    """Whether an energy ratio is too far from 1 for the same minimum: other windings."""
    return abs(ratio - 1) > OTHER_CLASS
