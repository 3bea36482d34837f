"""In-betweening: keep every n-th image of a motion as a keyframe, fill in the rest, compare with the motion itself.

The motions are solved from the shipped clips, so the numbers can be reproduced anywhere; they favour no particular
spline, but conclusions about people need captured motion, scored in the same way. One setting
for everything: a figure and an .npz of keyframes with the product's defaults, nothing else.
"""

from __future__ import annotations

import pinned  # noqa: F401  isort: skip  # before anything that imports NumPy

import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from bench import Effort, Section, Target, median, people
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation, RotationSpline, Slerp

from dynsplines import recordings
from dynsplines.clip import load as clips
from dynsplines.motion import continuous
from dynsplines.solver import inbetween
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.surface.points import places_of

Array = NDArray[np.float64]
FPS = 30.0
SPACINGS = (5, 10, 15)
RESTING_SPEED, RESTING_HEIGHT = 0.35, 0.06  # [m/s], [m]: a sole point that rests in the motion itself
ENDS = ("left_hand", "right_hand")
FEET = ("left_foot", "right_foot")
WORSE = {5: 1.05, 10: 1.05, 15: 1.10}  # than RotationSpline, joint angles may be


@dataclass(frozen=True)
class Motion:
    """A motion to be found again: the clip it is of, times (T,) [s] and configurations (T, nq)."""

    name: str
    clip: clips.Clip
    time: Array
    qpos: Array


def shipped_motion(name: str) -> Motion:
    """A shipped clip, solved, at 30 images a second."""
    clip = recordings.load(name)
    solution = inbetween(clip.problem)
    first, last = solution.path.span
    time = first + np.arange(int((last - first) * FPS + 1e-9) + 1) / FPS
    return Motion(name, clip, time, continuous(clip.figure, solution.at(time)))


def ours(motion: Motion, key_indices: NDArray[np.intp], folder: Path) -> Array:
    """Through the kept images with the product's defaults, from files as a user has them."""
    clip = clips.from_qpos("keys", motion.clip.scene, motion.time[key_indices], motion.qpos[key_indices], FPS, "keys")
    return inbetween(clip.problem).at(motion.time)


def _by_joint(motion: Motion, key_indices: NDArray[np.intp], places: Callable, turns: Callable) -> Array:
    """Positions and numbers by one interpolator, joint rotations by another."""
    tables = motion.clip.figure.tables
    out = places(motion.time[key_indices], motion.qpos[key_indices])(motion.time)
    for columns in tables.quaternion_columns.T:
        keys = Rotation.from_quat(np.roll(motion.qpos[np.ix_(key_indices, columns)], -1, axis=1))
        out[:, columns] = np.roll(turns(motion.time[key_indices], keys)(motion.time).as_quat(), 1, axis=1)
    return out


def slerp(motion: Motion, key_indices: NDArray[np.intp], _: Path) -> Array:
    return _by_joint(motion, key_indices, lambda t, y: lambda x: np.array([np.interp(x, t, c) for c in y.T]).T, Slerp)


def splines(motion: Motion, key_indices: NDArray[np.intp], _: Path) -> Array:
    return _by_joint(motion, key_indices, CubicSpline, RotationSpline)


METHODS: dict[str, Callable[[Motion, NDArray[np.intp], Path], Array]] = {
    "ours": ours,
    "SLERP": slerp,
    "RotationSpline": splines,
}


@dataclass(frozen=True)
class Features:
    """Positions: joint rotations (T, n, 4), hands and ankles (T, m, 3), sole points (T, p, 3), their heights."""

    turns: Array
    ends: Array
    soles: Array
    heights: Array

    @classmethod
    def of(cls, clip: clips.Clip, qpos: Array) -> Features:
        figure = clip.figure
        model, data = figure.model, mujoco.MjData(figure.model)
        ends = []
        for row in qpos:
            data.qpos[:] = row
            mujoco.mj_kinematics(model, data)
            ends.append([*(data.site(name).xpos.copy() for name in ENDS), *(data.body(n).xpos.copy() for n in FEET)])
        y = np.array([figure.to_state(row) for row in qpos])
        samples = Samples(figure, y, 0 * y, 0 * y)
        centres, _ = places_of(clip.context.points, samples)
        heights = np.min([surface.height(centres) for surface in clip.context.surfaces], axis=0)
        turns = qpos[:, figure.tables.quaternion_columns.T]
        return cls(turns, np.array(ends), centres.transpose(2, 1, 0), heights.T)


def score(motion: Motion, key_indices: NDArray[np.intp], qpos: Array) -> dict[str, float]:
    """The error of a reconstructed motion between keyframes.

    rot [degrees] of a joint but the root; ee [cm] of hands and ankles; deepest sole point [cm]; skate [cm/s] of sole
    points that rest in the true motion; npss, the distance of the power spectra (Gopalakrishnan et al., CVPR 2019)
    """
    true, filled = Features.of(motion.clip, motion.qpos), Features.of(motion.clip, continuous(motion.clip.figure, qpos))
    between = np.setdiff1d(np.arange(len(qpos)), key_indices)
    cosine = np.abs(np.einsum("tni,tni->tn", true.turns, filled.turns)).clip(0, 1)
    angle = np.degrees(2 * np.arccos(cosine))[between, 1:]
    speed = np.linalg.norm(np.gradient(true.soles, 1 / FPS, axis=0), axis=-1)
    rests = (speed < RESTING_SPEED) & (true.heights < RESTING_HEIGHT)
    both = rests[1:] & rests[:-1]
    moved = FPS * np.linalg.norm(np.diff(filled.soles[..., :2], axis=0), axis=-1)
    return {
        "rot": float(angle.mean()),
        "ee": float(100 * np.linalg.norm(filled.ends - true.ends, axis=-1)[between].mean()),
        "pen": float(100 * np.maximum(-filled.heights, 0).max()),
        "skate": float(100 * moved[both].mean()) if both.any() else 0.0,
        "npss": spectral_distance(true.turns, filled.turns),
    }


def spectral_distance(true: Array, reconstructed: Array) -> float:
    """Σ over features of the distance between cumulative normalised power spectra, weighted by the true power."""
    signs = np.where(np.einsum("ni,ni->n", true[0], reconstructed[0]) < 0, -1.0, 1.0)
    powers = [
        np.abs(np.fft.rfft(part.reshape(len(part), -1), axis=0)) ** 2 for part in (true, reconstructed * signs[:, None])
    ]
    totals = [power.sum(axis=0) for power in powers]
    cumulative = [np.cumsum(p / np.maximum(total, 1e-300), axis=0) for p, total in zip(powers, totals, strict=True)]
    apart = np.abs(cumulative[0] - cumulative[1]).sum(axis=0)
    return float(np.sum(apart * totals[0]) / np.sum(totals[0]))


MEASURES = ("rot", "ee", "pen", "skate", "npss")


def measure(effort: Effort) -> Section:
    section = Section(
        "In-betweening the motions of the shipped clips, every n-th of 30 images a second kept, means over clips",
        ("every", "method", "clips", "joints [°]", "hands, ankles [cm]", "deepest sole [cm]", "skate [cm/s]", "npss"),
    )
    names = people()
    names = names[: effort.count(len(names), 2)]
    rows: list[dict[str, Any]] = []
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            effort.report(name)
            motion = shipped_motion(name)
            for every in SPACINGS:
                indices = np.arange(0, motion.time.size, every)
                if indices.size < 3:
                    continue
                cut = Motion(name, motion.clip, motion.time[: indices[-1] + 1], motion.qpos[: indices[-1] + 1])
                for method, fill in METHODS.items():
                    scores = score(cut, indices, fill(cut, indices, Path(folder)))
                    rows.append({"clip": name, "every": every, "method": method} | scores)
    means: dict[tuple[int, str], dict[str, float]] = {}
    for every in SPACINGS:
        for method in METHODS:
            matching = [row for row in rows if row["every"] == every and row["method"] == method]
            means[every, method] = {key: float(np.mean([row[key] for row in matching])) for key in MEASURES}
            section.add(every, method, len(matching), *means[every, method].values())
    best = {key: [min(means[e, m][key] for m in METHODS if m != "ours") for e in SPACINGS] for key in MEASURES}
    for key in ("ee", "pen", "skate"):
        worst = max(means[e, "ours"][key] / max(b, 1e-9) for e, b in zip(SPACINGS, best[key], strict=True))
        section.targets.append(Target(f"{key}: ours / the better of the others, worst spacing", worst, 1.0))
    for every in SPACINGS:
        turns = means[every, "ours"]["rot"] / means[every, "RotationSpline"]["rot"]
        section.targets.append(Target(f"rot: ours / RotationSpline, every {every}", turns, WORSE[every]))
    section.notes = [
        f"motions: {', '.join(names)}; the true motion was made by this solver from fewer keyframes, which favours it",
        f"median skate of ours {median([r['skate'] for r in rows if r['method'] == 'ours']):.1f} cm/s; "
        "splines: SciPy's CubicSpline for positions with RotationSpline for joints; SLERP with straight lines",
    ]
    section.data = {"rows": rows}
    return section
