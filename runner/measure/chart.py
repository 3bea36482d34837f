"""Charts of a motion: foot height, unit magnitude, Euler-Lagrange deviation, penalties per evaluation."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator

from ..system.output import Replacement

ENDINGS = (".png", ".svg", ".pdf")
BEFORE, AFTER = "#b5541c", "#1f6f8b"
INK = "#22303a"
COLOURS, STROKES = 10, ("-", "--", ":")  # number of matplotlib's colours; the stroke changes after each 10 lines


def style(size: float) -> dict[Any, Any]:
    """Return the style of charts: open at the top and on the right, text of a size [points]."""
    return {"axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": INK, "font.size": size}


def draw(name: str, report: dict[str, Any], trace: list[Any], key_times: Collection[float], target: Path) -> None:
    """Write four charts as one picture, completely or not at all."""
    with plt.rc_context(style(9)):
        figure, axes = plt.subplots(2, 2, figsize=(12, 7.2), layout="constrained")
        try:
            figure.suptitle(f"{name}: before and after", color=INK, fontsize=12, x=0.01, ha="left", parse_math=False)
            curves = report["curves"]
            _heights(axes[0, 0], curves, key_times)
            _lengths(axes[0, 1], curves, key_times)
            _tenths(axes[1, 0], curves)
            _penalties(axes[1, 1], trace)
            with Replacement(target) as temporary:
                figure.savefig(temporary, dpi=120, format=target.suffix[1:].lower())
        finally:
            plt.close(figure)


def _heights(axes: Axes, curves: dict[str, Any], key_times: Collection[float]) -> None:
    axes.set_title("lowest contact point over its surface", loc="left")
    for side, colour in (("before", BEFORE), ("after", AFTER)):
        rows = list(curves[side]["height"].values())
        if rows:
            lowest = 100 * np.min(rows, axis=0)
            time = curves[side]["time"]
            axes.plot(time, lowest, color=colour, lw=1.6, label=side)
            axes.fill_between(time, np.minimum(lowest, 0), 0, color=colour, alpha=0.35, lw=0)
    axes.axhline(0, color=INK, lw=0.8)
    _mark(axes, key_times)
    axes.set(xlabel="time [s]", ylabel="height [cm]")
    if axes.get_legend_handles_labels()[0]:
        low, high = axes.get_ylim()
        axes.set_ylim(max(low, -40), min(high, 40) if low < 30 else high)
        axes.legend(frameon=False)


def _lengths(axes: Axes, curves: dict[str, Any], key_times: Collection[float]) -> None:
    axes.set_title("length of the quaternions before normalising", loc="left")
    for side, colour in (("before", BEFORE), ("after", AFTER)):
        data = curves[side]
        axes.fill_between(data["time"], data["shortest"], data["longest"], color=colour, alpha=0.55, lw=0, label=side)
    axes.axhline(1, color=INK, lw=0.8)
    _mark(axes, key_times)
    axes.set(xlabel="time [s]", ylabel="shortest to longest |q|")
    axes.legend(frameon=False)


def _tenths(axes: Axes, curves: dict[str, Any]) -> None:
    axes.set_title("Euler-Lagrange deviation over tenths of the clip", loc="left")
    highest = 0.0
    for side, colour, shift in (("before", BEFORE, -0.2), ("after", AFTER, 0.2)):
        values = curves[side]["EL over tenths"]
        highest = max(highest, *values)
        axes.bar(np.arange(1, len(values) + 1) + shift, values, width=0.4, color=colour, label=side)
    axes.set(xlabel="tenth", ylabel="∫ |EL| dt", xticks=range(1, 11))
    if highest > 0:
        axes.set_yscale("log")
    axes.legend(frameon=False)


def _penalties(axes: Axes, trace: list[Any]) -> None:
    axes.set_title("penalties at every evaluation that lowered the objective", loc="left")
    if trace:
        evaluations = [entry[0] for entry in trace]
        axes.plot(evaluations, [entry[2] for entry in trace], color=INK, lw=2, label="objective")
        for i, name in enumerate(trace[-1][3]):
            shares = [max(entry[3].get(name, 0.0), 1e-9) for entry in trace]
            stroke = STROKES[i // COLOURS % len(STROKES)]
            axes.plot(evaluations, shares, stroke, color=f"C{i % COLOURS}", lw=1.1, label=name)
        highest = max(entry[2] for entry in trace)
        axes.set(xlabel="evaluation", ylabel="weighted share")
        axes.xaxis.set_major_locator(MaxNLocator(integer=True))
        if highest > 0:
            axes.set(yscale="log", ylim=(2e-5 * highest, 2 * highest))
        axes.legend(frameon=False, ncols=2, fontsize=8)


def _mark(axes: Axes, key_times: Collection[float]) -> None:
    for t in key_times:
        axes.axvline(t, color=INK, lw=0.5, alpha=0.25)
