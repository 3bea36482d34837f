"""Shipped clips whose keyframes were moved a little at random: the motion moves a little too, or does it whip?

Alone: python benchmarks/perturbed.py [--clips NAME ...] [--first SEED] [--count SETS]
"""

from __future__ import annotations

import pinned  # noqa: F401  isort: skip  # before anything that imports NumPy

import argparse
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace

import numpy as np
import report
from bench import Effort, Section, Target, median, people, seconds, worst
from rekeyed import with_keys

from dynsplines import recordings
from dynsplines.clip import load as clips
from dynsplines.clip.contacts import contacts
from dynsplines.clip.parse import table_of
from dynsplines.clip.text import tables, text_of
from dynsplines.errors import UserError
from dynsplines.motion import samples_at
from dynsplines.solver import Frame, Solution, inbetween
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty.motion.acceleration import relative_accelerations

SETS = (100, 2)  # of every clip
TURN, SHIFT = np.radians(5.0), 0.03  # [rad] of every ball joint, [m] of the root
RATE = 200.0  # [1/s] of the samples in which peaks are sought
MOST, MOST_OF_ALL, QUANTILE = 3.0, 6.0, 0.95  # times the shipped clip's peak: of most sets, of all; which most is
FAR = 0.5  # [m]


@dataclass(frozen=True)
class Violence:
    """Measures of a motion's violence.

    peak      [rad/s²] the largest angular acceleration of a joint, and the link that it turns
    farthest  [m] a link's origin from its place on the raw spline at the same time, and which link's
    """

    peak: float
    link: str
    farthest: float
    limb: str

    @classmethod
    def of(cls, motion: Solution) -> Violence:
        """Measured on a grid from the first keyframe to the last."""
        first, last = motion.path.span
        t = np.linspace(first, last, round(RATE * (last - first)) + 1)
        samples, raw = (samples_at(motion.figure, path, t) for path in (motion.path, path_of(motion.raw)))
        sizes = relative_accelerations(samples)[1].max(axis=1)
        apart = _distances(samples, raw)
        names = [link.name for link in motion.figure.links]
        turns, strays = int(sizes.argmax()), int(apart.argmax())
        return cls(float(sizes[turns]), names[turns], float(apart[strays]), names[strays])


def _distances(a: Samples, b: Samples) -> Array:
    """(L,) [m] how far links' origins are from each other at most."""
    return np.linalg.norm(a.links.x - b.links.x, axis=0).max(axis=1)


@dataclass(frozen=True)
class Outcome:
    """The result for one set of keyframes.

    ratio    its peak beside the shipped clip's
    parts    the terms of E by name
    dropped  the clip's contacts that its keyframes contradict
    """

    clip: str
    seed: int
    ratio: float
    violence: Violence
    seconds: float
    evaluations: int
    parts: dict[str, float]
    dropped: int

    @property
    def is_excessive(self) -> bool:
        """Whether it is beyond what most or all sets are to keep to."""
        return self.ratio > MOST or self.violence.farthest > FAR

    @property
    def text(self) -> str:
        """One line on it."""
        parts = sorted(self.parts.items(), key=lambda part: -part[1])
        terms = ", ".join(f"{name} {value:.3g}" for name, value in parts if value >= 0.01)
        return (
            f"{self.clip} seed {self.seed}: {self.ratio:.1f} × ({self.violence.link}), {self.violence.limb} "
            f"{100 * self.violence.farthest:.0f} cm away; E = {sum(self.parts.values()):.3g} ({terms})"
        )


def perturbed(clip: clips.Clip, seed: int) -> clips.Clip:
    """The clip with every fixed ball joint of every keyframe turned about a random axis and fixed positions of its root
    moved in a random direction; in a loop the last keyframe moves as the first does."""
    rng = np.random.default_rng(seed)
    keys = [_moved(clip.figure, key, rng) for key in clip.keys]
    if clip.ends == "periodic":
        keys[-1] = _moved(clip.figure, clip.keys[-1], np.random.default_rng(seed))
    return with_keys(_without_contradictions(clip, keys), keys)


def _moved(figure: Figure, key: Frame, rng: np.random.Generator) -> Frame:
    qpos = np.array(key.state)
    for link in figure.links[1:]:
        if link.kind not in (JointKind.FREE, JointKind.BALL):
            continue
        direction = rng.normal(size=3)
        direction /= np.linalg.norm(direction)
        if link.kind is JointKind.FREE:
            columns = slice(link.qpos, link.qpos + 3)
            qpos[columns] += SHIFT * direction * key.fixed[columns]
        elif key.fixed[link.qpos]:
            columns = slice(link.qpos, link.qpos + 4)
            qpos[columns] = quat.product(qpos[columns], quat.from_rotation_vector(TURN * direction))
    return replace(key, state=qpos)


def _without_contradictions(clip: clips.Clip, keys: Sequence[Frame]) -> clips.Clip:
    """The clip without the contacts that other keyframes contradict, which would be refused."""
    table = table_of(clip.text, clip.name)
    timeline = replace(clip.problem, keys=tuple(keys)).raw
    samples = Samples.still(clip.figure, timeline.states)
    valid: list[int] = []
    for i in range(len(table.contact)):
        try:
            contacts(samples, timeline, [table.contact[k] for k in (*valid, i)], clip.name, clip.context.points)
        except UserError:
            continue
        valid.append(i)
    if len(valid) == len(table.contact):
        return clip
    content = tables(table)
    return replace(clip, text=text_of(content | {"contact": [content["contact"][i] for i in valid]}))


def solved(clip: clips.Clip) -> Solution:
    """Solve as `dynsplines solve` does."""
    return inbetween(clip.problem)


def outcome(clip: clips.Clip, seed: int, peak: float) -> Outcome:
    """The result for one set, relative to the shipped clip's peak [rad/s²]."""
    other = perturbed(clip, seed)
    spent, motion = seconds(lambda: solved(other))
    measured, parts, dropped = (
        Violence.of(motion),
        motion.trace[-1][3],
        len(clip.context.schedule.on_ground) - len(other.context.schedule.on_ground),
    )
    ratio = measured.peak / peak if peak > 0 else 1.0  # a figure without joints has no peak, moved or not
    return Outcome(clip.name, seed, ratio, measured, spent, motion.evaluations, parts, dropped)


def compared(names: Sequence[str], seeds: Sequence[int], effort: Effort) -> Section:
    """The table of some clips, each with the same seeds."""
    section = Section(
        f"Keyframes of shipped clips turned by {np.degrees(TURN):.0f}° a joint and moved by {100 * SHIFT:.0f} cm at "
        "random: peak angular acceleration of a joint beside the shipped clip's own",
        ("clip", "sets", "own peak [rad/s²]", "ratio: median", f"{QUANTILE:.0%}", "worst", "farthest limb [cm]",
         "shipped [cm]", f"over {MOST:g} ×", f"over {MOST_OF_ALL:g} ×", f"over {100 * FAR:.0f} cm", "solve [s]"),
    )  # fmt: skip
    every: list[Outcome] = []
    shares: list[float] = []
    for name in names:
        clip = recordings.load(name)
        shipped = Violence.of(solved(clip))
        outcomes = []
        for seed in seeds:
            effort.report(f"{name}, seed {seed}")
            outcomes.append(outcome(clip, seed, shipped.peak))
        ratios = [result.ratio for result in outcomes]
        far = max(outcomes, key=lambda result: result.violence.farthest).violence
        shares.append(float(np.quantile(ratios, QUANTILE)))
        section.add(
            name, len(outcomes), shipped.peak, median(ratios), shares[-1], worst(ratios),
            f"{100 * far.farthest:.0f} ({far.limb})", 100 * shipped.farthest, sum(ratio > MOST for ratio in ratios),
            sum(ratio > MOST_OF_ALL for ratio in ratios), sum(result.violence.farthest > FAR for result in outcomes),
            median([result.seconds for result in outcomes]),
        )  # fmt: skip
        every += outcomes
    section.targets = [
        Target(f"ratio of {QUANTILE:.0%} of a clip's sets, the worst clip", worst(shares), MOST),
        Target("ratio of all sets", worst([result.ratio for result in every]), MOST_OF_ALL),
        Target(
            "a limb from its place on the raw spline",
            worst([result.violence.farthest for result in every]),
            FAR,
            unit="m",
        ),
    ]
    beyond = [result.text for result in every if result.is_excessive]
    section.notes = [
        "only what keyframes fix is moved; the first and the last keyframe of a loop alike; the raw spline is that of "
        "the moved keyframes, the own peak that of the shipped clip's solved motion; contacts that the moved keyframes "
        f"contradict by more than a contact may drift are left out: {sum(result.dropped for result in every)}",
        *(beyond or [f"no set is over {MOST:g} × or has a limb over {100 * FAR:.0f} cm away"]),
    ]
    section.data = {"sets": [asdict(result) for result in every]}
    return section


def measure(effort: Effort) -> Section:
    return compared(people(), range(effort.count(*SETS)), effort)


def main() -> None:
    parser = argparse.ArgumentParser(description="keyframes of shipped clips, moved at random")
    parser.add_argument("--clips", nargs="+", default=people(), metavar="NAME")
    parser.add_argument("--first", type=int, default=0, metavar="SEED")
    parser.add_argument("--count", type=int, default=SETS[0], metavar="SETS")
    chosen = parser.parse_args()
    section = compared(chosen.clips, range(chosen.first, chosen.first + chosen.count), Effort())
    print("\n".join([section.title, "", *report.table(section.columns, section.rows), ""]))
    print("\n".join(f"- {note}" for note in section.notes))


if __name__ == "__main__":
    main()
