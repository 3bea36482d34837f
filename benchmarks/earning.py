"""What each soft constraint buys: the shipped clips solved without it, and what it watches measured with and without.

Alone: python benchmarks/earning.py [--clips NAME ...] [--terms NAME ...]
"""

from __future__ import annotations

import pinned  # noqa: F401  isort: skip  # before anything that imports NumPy

import argparse
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import report
from bench import Effort, Section, median
from perturbed import solved

from dynsplines import models, recordings
from dynsplines.solver import Solution
from dynsplines.solver.array import Array

RATE = 200.0  # [1/s] of the samples over which integrals are summed
LITTLE = 1e-3  # of E: a term that comes to no more, with it and without it, has nothing to do in a clip
WORSE = 1.1  # times what it watches, from which on a clip is better for a term


@dataclass(frozen=True)
class Outcome:
    """One clip without one term.

    ratio  integral of what the term watches, without it divided by with it
    rest   the other terms of E, the same way
    share  of E that the term comes to without it, by its weight
    """

    clip: str
    term: str
    ratio: float
    rest: float
    share: float


def costs(of: Solution, motion: Solution) -> dict[str, float]:
    """The terms of one motion's E by name, of another's path, on one fine grid."""
    first, last = of.path.span
    edges = np.linspace(first, last, round(RATE * (last - first)) + 1)
    integrals: Array = of.objective.integrals(motion.path, edges)
    return {term.penalty.name: term.factor * float(v) for term, v in zip(of.objective.terms, integrals, strict=True)}


def outcomes(name: str, terms: Sequence[str], effort: Effort) -> list[Outcome]:
    """One clip without each of some terms, those that have something to do in it."""
    clip = recordings.load(name)
    whole = solved(clip)
    with_it = costs(whole, whole)
    results = []
    for term in with_it:
        if terms and term not in terms:
            continue
        effort.report(f"{name} without {term}")
        remaining = tuple((penalty, weight) for penalty, weight in clip.penalties if penalty.name != term)
        if not remaining or len(remaining) == len(clip.penalties):
            continue
        without = costs(whole, solved(clip.with_problem(penalties=remaining)))
        rest, before = (sum(v for key, v in side.items() if key != term) for side in (without, with_it))
        if max(without[term], with_it[term]) < LITTLE * sum(with_it.values()):
            continue
        share = without[term] / max(with_it[term], LITTLE**2 * sum(with_it.values()))
        results.append(Outcome(name, term, share, rest / before, without[term] / sum(with_it.values())))
    return results


def compared(names: Sequence[str], terms: Sequence[str], effort: Effort) -> Section:
    """A row a term, over all clips in which it has something to do."""
    section = Section(
        "Shipped clips solved without one soft constraint: what that one watches, and the rest of E, beside the whole",
        ("soft constraint", "clips", "what it watches: median ×", "most ×", "rest of E: median ×",
         f"clips better for it by {WORSE:g} ×"),
    )  # fmt: skip
    results = [outcome for name in names for outcome in outcomes(name, terms, effort)]
    for term in dict.fromkeys(outcome.term for outcome in results):
        of_term = [outcome for outcome in results if outcome.term == term]
        better = [outcome for outcome in of_term if outcome.ratio > WORSE]
        section.add(
            term, len(of_term), median([outcome.ratio for outcome in of_term]),
            max(outcome.ratio for outcome in of_term),
            median([outcome.rest for outcome in of_term]), ", ".join(outcome.clip for outcome in better) or "none",
        )  # fmt: skip
    section.notes = ["integrals of one fine grid; a clip counts where the term comes to a thousandth of E or more"]
    return section


def measure(effort: Effort) -> Section:
    return compared(sorted(models.clips())[: effort.count(100, 2)], (), effort)


def main() -> None:
    parser = argparse.ArgumentParser(description="shipped clips without one soft constraint")
    parser.add_argument("--clips", nargs="+", default=sorted(models.clips()), metavar="NAME")
    parser.add_argument("--terms", nargs="+", default=(), metavar="NAME")
    chosen = parser.parse_args()
    section = compared(chosen.clips, chosen.terms, Effort())
    print("\n".join([section.title, "", *report.table(section.columns, section.rows), ""]))
    print("\n".join(f"- {note}" for note in section.notes))


if __name__ == "__main__":
    main()
