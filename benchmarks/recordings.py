"""Recordings with faults added, cleaned: how near the truth comes back, what skates, sinks and hovers, stances found.

The true motions are the people's clips that ship, solved; or, with DYNSPLINES_TRUTH=FOLDER, those of a folder: NAME.npz
with time (T,) and qpos (T, nq) beside NAME.xml. Faults, all at once and at 30 images a second: the root slides at
5 cm/s, in a direction that goes round once in four seconds or (a second row) straight on, sinks and hovers by 2 cm for
a second each, every axis of its place and of every rotation has white noise of 1 cm and 2°, and it has two gaps of ten
images. A true motion whose soles rest over its own floor, or in it, by the middle of their
heights when they are slow, is set down on it first: ten captured clips hover by up to 15 cm.

Resting points and their skate are measured at the marks of the soles, where a figure has some; depth with all geoms of
the figure; hovering with the round soles under the marks.
"""

from __future__ import annotations

import io
import os
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from bench import Effort, Section, Target, people
from rich.console import Console

from dynsplines import recordings, solving
from dynsplines.clean.cleaning import Cleaned, clean, depth
from dynsplines.clean.repairs import repair
from dynsplines.clip import load as clips
from dynsplines.clip.context import Context
from dynsplines.clip.posing.places import sole_points
from dynsplines.clip.tracking.problem import tracking_context
from dynsplines.exchange.recording import Recording
from dynsplines.motion import Sampled, samples_at
from dynsplines.scene.compose import compose, figure_spec
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Mask
from dynsplines.solver.curve.recording import Track
from dynsplines.solver.curve.spline import Path as Curve
from dynsplines.solver.figure.figure import Figure, quaternion_columns
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import TrackingPenalty
from dynsplines.solver.penalty.motion.acceleration import relative_accelerations
from dynsplines.solver.surface.heights import height_over
from dynsplines.solver.surface.points import places_of
from dynsplines.system.progress import Progress

FPS = 30.0
SLIDE, ROUND_IN = 0.05, 4.0  # [m/s], [s]
SINK, EVERY = 0.02, 1.0  # [m], [s]
METRES, DEGREES = 0.01, 2.0  # of noise, an axis
GAPS, GAP = 2, 10  # how many, of so many images each
STILL, LOW = 0.35, 0.06  # [m/s], [m] of a point that rests, in the truth
LEAST, ABOUT = 4, 2  # images of a stance that counts; that one may be longer at either end
NEAR, SKATE, DEPTH, HOVER, PEAK, FOUND, FALSE = 0.6, 4.0, 2.0, 5.0, 1.5, 0.9, 0.1


@dataclass(frozen=True, eq=False)
class Truth:
    """A figure's true motion: time (T,) [s] from 0 on, qpos (T, nq)."""

    name: str
    figure: Figure
    time: Array
    qpos: Array


def truths(effort: Effort) -> Iterator[Truth]:
    """The true motions: those of the folder, or the shipped ones."""
    folder = os.environ.get("DYNSPLINES_TRUTH")
    if folder is not None:
        for file in sorted(Path(folder).glob("*.npz")):
            scene = compose(figure_spec(str(file.with_suffix(".xml"))))
            data = np.load(file)
            figure = clips.figure_of(scene, file.stem)
            yield set_down(Truth(file.stem, figure, data["time"] - data["time"][0], data["qpos"]))
        return
    for name in people()[: effort.count(20, 2)]:
        clip = recordings.load(name)
        motion = solving.solve(clip, Progress(Console(file=io.StringIO())))
        at = Sampled.of(motion, FPS)
        yield set_down(Truth(name, clip.figure, at.time - at.time[0], at.qpos))


def set_down(truth: Truth) -> Truth:
    """With its slow soles on the ground."""
    ground = tracking_context(truth.figure, truth.time, truth.figure.to_state(truth.qpos), truth.name)
    height, speed = soles_of(truth, marked(ground, truth.qpos))
    qpos = truth.qpos.copy()
    qpos[:, 2] -= np.median(height[speed < STILL])
    return replace(truth, qpos=qpos)


def marked(ground: Context, qpos: Array) -> Context:
    """With the marks of the soles themselves in place of what rolls under them."""
    return ground.with_schedule(points=sole_points(ground.figure, qpos))


def faulty(truth: Truth, rng: np.random.Generator, *, straight: bool) -> tuple[Array, Array]:
    """Times and qpos of the bad recording, the gaps left out."""
    qpos, since = truth.qpos.copy(), truth.time
    angle = 2 * np.pi / ROUND_IN * since + rng.uniform(0, 2 * np.pi)
    path = (
        np.stack([np.sin(angle) - np.sin(angle[0]), np.cos(angle[0]) - np.cos(angle)], axis=1) * ROUND_IN / (2 * np.pi)
    )
    if straight:
        path = since[:, None] * np.array([np.cos(angle[0]), np.sin(angle[0])])
    qpos[:, :2] += SLIDE * path
    qpos[:, 2] += SINK * np.where(np.floor(since / EVERY) % 2, 1, -1)
    qpos[:, :3] += rng.normal(0, METRES, (len(qpos), 3))
    for link in truth.figure.links[1:]:
        columns = quaternion_columns(link)
        if columns is not None:
            noise = quat.from_rotation_vector(rng.normal(0, np.radians(DEGREES), (len(qpos), 3)))
            qpos[:, columns] = quat.product(qpos[:, columns], noise)
    keep = np.ones(len(qpos), bool)
    for k in range(GAPS if len(qpos) > 4 * GAP else 0):
        first = len(qpos) * (k + 1) // (GAPS + 1)
        keep[first : first + GAP] = False
    return since[keep], qpos[keep]


def resting(truth: Truth, ground: Context) -> Mask:
    """(p, T) which points of the soles truly rest."""
    height, speed = soles_of(truth, ground)
    return (speed < STILL) & (height < LOW)


def soles_of(truth: Truth, ground: Context) -> tuple[Array, Array]:
    """Heights [m] and speeds [m/s] (p, T) of the points of the soles."""
    places, height = soles(truth.figure, ground, truth.figure.to_state(truth.qpos))
    return height, np.linalg.norm(np.gradient(places, truth.time, axis=2), axis=0)


def soles(figure: Figure, ground: Context, states: Array) -> tuple[Array, Array]:
    """Places (3, p, T) and heights (p, T) [m] of the points of the soles."""
    places, radii = places_of(ground.points, Samples(figure, states, 0 * states, 0 * states))
    return places, height_over(ground.surfaces, places, radii)[0]


@dataclass(frozen=True)
class Score:
    """The result for one recording."""

    before: float
    after: float
    skate: float
    detected_skate: float
    body_skate: float
    depth: float
    hover: float
    peak: float
    found: tuple[int, int]
    false: tuple[int, int]
    speed: float


def ends(figure: Figure, states: Array, result: Cleaned) -> Array:
    """(3, n, T) [m] hands and feet."""
    near = result.problem.penalties[0][0]
    assert isinstance(near, TrackingPenalty)
    links, positions = near.ends
    return Samples(figure, states, 0 * states, 0 * states).links.points(links, positions)[0]


def scored(truth: Truth, rng: np.random.Generator, *, straight: bool) -> Score:
    figure = truth.figure
    when, bad = faulty(truth, rng, straight=straight)
    begin = time.perf_counter()
    mended, known = repair(figure, Recording(when, bad.copy(), name=truth.name))
    ground = tracking_context(figure, mended.time, figure.to_state(mended.qpos), truth.name)
    result = clean(ground, {}, mended, known)
    spent = time.perf_counter() - begin
    marks = marked(ground, mended.qpos)
    assert [point.name for point in marks.points] == [point.name for point in ground.points]
    here = (truth.time >= result.before.span[0]) & (truth.time <= result.before.span[1])
    t = truth.time[here]
    after, before = result.after.at(t), result.before.at(t)
    true = figure.to_state(truth.qpos[here])
    wanted = ends(figure, true, result)
    off = [float(np.linalg.norm(ends(figure, s, result) - wanted, axis=0).mean()) for s in (before, after)]
    rests = resting(Truth(truth.name, figure, t, truth.qpos[here]), marks)
    both = rests[:, 1:] & rests[:, :-1]
    is_recorded = np.array([np.abs(when - moment).min() < 0.5 / FPS for moment in t])
    recorded = both & is_recorded[1:] & is_recorded[:-1]
    paths = [np.linalg.norm(np.diff(soles(figure, marks, s)[0][:2], axis=2), axis=0) for s in (after, true)]
    skates = [
        float(horizontal[mask].mean() * FPS) if mask.any() else 0.0
        for horizontal, mask in ((paths[0], both), (paths[0], recorded), (paths[1], both))
    ]
    fine = np.linspace(t[0], t[-1], 4 * t.size)
    places, _ = soles(figure, ground, result.after.at(fine))
    stand = np.zeros((len(ground.points), t.size), bool)
    hover = 0.0
    for rest in result.rests:
        row = ground.points.index(rest.point)
        stand[row] |= (t >= rest.first) & (t <= rest.last)
        during = (fine >= rest.first) & (fine <= rest.last)
        on = ground.surfaces if rest.surface is None else (rest.surface,)
        over, _ = height_over(on, places[:, row : row + 1, during], np.array([rest.point.radius]))
        hover = max(hover, float(over.max(initial=0.0)))
    peaks = [peak(figure, path, fine) for path in (result.after, Track.of(figure, truth.time, truth.qpos).path)]
    return Score(
        before=off[0],
        after=off[1],
        skate=skates[0],
        detected_skate=skates[1],
        body_skate=skates[2],
        depth=float(depth(ground, result.after, fine).max()),
        hover=hover,
        peak=peaks[0] / peaks[1],
        found=_hits(rests, stand, LEAST),
        false=_false(rests, stand),
        speed=float((t[-1] - t[0]) / spent),
    )


def peak(figure: Figure, path: Curve, t: Array) -> float:
    """[rad/s²] the largest acceleration of a joint."""
    return float(relative_accelerations(samples_at(figure, path, t))[1].max())


def _runs(row: Mask) -> list[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(np.concatenate([[0], row.astype(int), [0]])))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


def _hits(true: Mask, detected: Mask, least: int) -> tuple[int, int]:
    """The number of true stances detected for at least half of their duration, and their total."""
    every = [(i, a, b) for i, row in enumerate(true) for a, b in _runs(row) if b - a >= least]
    return sum(detected[i, a:b].mean() >= 0.5 for i, a, b in every), len(every)


def _false(true: Mask, detected: Mask) -> tuple[int, int]:
    """Detected stances more than two samples off a true one for half of their duration, and the total."""
    near = true.copy()
    for late in range(1, ABOUT + 1):
        near[:, late:] |= true[:, :-late]
        near[:, :-late] |= true[:, late:]
    every = [(i, a, b) for i, row in enumerate(detected) for a, b in _runs(row)]
    return sum(near[i, a:b].mean() < 0.5 for i, a, b in every), len(every)


def measure(effort: Effort) -> Section:
    section = Section(
        "Recordings with faults added, cleaned with defaults: beside the truth.",
        ("clip", "drift", "hands, feet off [cm]", "after | before", "skate [cm/s]", "but in gaps", "the body's own",
         "deepest [mm]", "hover [mm]", "peak | true", "stances found", "false", "× real time"),
    )  # fmt: skip
    every: dict[str, list[Score]] = {"round": [], "straight": []}
    for truth in truths(effort):
        for drift, scores in every.items():
            effort.report(f"{truth.name}, {drift}")
            s = scored(truth, np.random.default_rng(1), straight=drift == "straight")
            scores.append(s)
            section.add(
                truth.name, drift, f"{100 * s.before:.1f} -> {100 * s.after:.1f}", s.after / s.before, 100 * s.skate,
                100 * s.detected_skate, 100 * s.body_skate, 1000 * s.depth, 1000 * s.hover, s.peak,
                f"{s.found[0]} of {s.found[1]}", f"{s.false[0]} of {s.false[1]}", s.speed,
            )  # fmt: skip
    for drift, scores in every.items():
        hits, false = (np.sum([getattr(s, of) for s in scores], axis=0) for of in ("found", "false"))
        section.targets += [
            Target(f"{drift}: distance of hands and feet, after | before",
                   float(np.mean([s.after / s.before for s in scores])), NEAR),
            Target(f"{drift}: skate while truly resting", 100 * float(np.mean([s.skate for s in scores])), SKATE,
                   unit="cm/s"),
            Target(f"{drift}: the same, but for the gaps, of which nothing is known",
                   100 * float(np.mean([s.detected_skate for s in scores])), SKATE, unit="cm/s"),
            Target(f"{drift}: deepest of the figure", 1000 * max(s.depth for s in scores), DEPTH, unit="mm"),
            Target(f"{drift}: hover of resting soles", 1000 * max(s.hover for s in scores), HOVER, unit="mm"),
            Target(f"{drift}: peak joint acceleration | the true one", max(s.peak for s in scores), PEAK),
            Target(f"{drift}: share of true stances found", float(hits[0] / max(hits[1], 1)), FOUND, least=True),
            Target(f"{drift}: share of stances that are none", float(false[0] / max(false[1], 1)), FALSE),
        ]  # fmt: skip
    return section
