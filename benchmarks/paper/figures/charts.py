"""Figures 9 and 10: the length of a quaternion along its path, and how far paths are from optimal, tenth by tenth.

Strokes are the paper's. Figure 9: dashed paths are not optimised to the end, the solid one is. Figure 10: dotted the
raw spline, dashed one variable frame between two keyframes, solid three, dash-dotted two frames in all, where the
deviation is largest.
"""

from __future__ import annotations

from dataclasses import dataclass

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from dynsplines.measure.chart import INK, style
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.problem import Improvement, Settings

from ..orientations import FEW_FRAMES, PAPER, TENTHS, Run, figure_ten, strong_tenths, unit_deviation, weak_tenths
from .captioned import Picture

DPI = 120  # dots an inch
RATE = 500  # [1/s] points of a curve
SHOWN_STEPS = 3  # dashed paths, the raw spline among them: the next ones lie on the solid one
PAPERS_LIMIT = 0.002  # deviation from unit length that the paper reports
FEW = f"adaptive {FEW_FRAMES}"
STROKES: dict[str, tuple[str, str]] = {
    "raw": (":", "raw spline"),
    "1": ("--", "1 variable frame a segment"),
    "3": ("-", "3 variable frames a segment"),
    FEW: ("-.", f"{FEW_FRAMES} in all, where the deviation is largest"),
}


@dataclass(frozen=True)
class Lengths:
    """Figure 9's curves.

    time   (T,) [s]
    raw    (T,) |q| of the raw spline; steps: (n, T) after each step of the search; best: (T,) of the optimum
    worst  max ||q| − 1| of the optimum
    """

    time: Array
    raw: Array
    steps: Array
    best: Array
    worst: float

    @classmethod
    def of(cls, keys: list[Frame]) -> Lengths:
        """Along the path through orientations by the paper's weights, one variable frame a segment."""
        improvements: list[Improvement] = []
        motion = Run(keys).inbetween(PAPER, Settings(variable=1, frames=0), improvements.append)
        first, last = motion.path.span
        time = np.linspace(first, last, round(RATE * (last - first)) + 1)
        before = [np.linalg.norm(step.path.at(time), axis=1) for step in improvements[:-1]][:SHOWN_STEPS]
        best = np.linalg.norm(motion.path.at(time), axis=1)
        return cls(time, before[0], np.array(before[1:]).reshape(-1, time.size), best, unit_deviation(motion.path))

    @property
    def caption(self) -> str:
        steps = " and ".join(str(i + 1) for i in range(len(self.steps)))
        limit = "as in the paper, less than" if self.worst < PAPERS_LIMIT else "in the paper less than"
        within, limit = f"{100 * self.worst:.2g} %", f"{100 * PAPERS_LIMIT:g} %"
        return (
            "Length of the quaternion along the path of figure 7, with the paper's weights (unit length to covariant "
            "acceleration 2 : 5) and one variable frame between two keyframes (fine upright lines). Dashed: paths that "
            f"are not optimised to the end: the raw spline, and after {steps} steps of the search. Solid: the "
            f"optimised path, within {within} of unit length at all times (the paper: less than {limit})."
        )


def draw_lengths(lengths: Lengths, keys: list[Frame]) -> Picture:
    """Figure 9."""
    figure, (axes,) = _sheet(1)
    try:
        axes.plot(lengths.time, lengths.raw, "--", color=INK, alpha=0.4, lw=1.2, label="raw spline")
        for i, step in enumerate(lengths.steps, 1):
            shade = 0.4 + 0.5 * i / len(lengths.steps)
            axes.plot(lengths.time, step, "--", color=INK, alpha=shade, lw=1.2, label=f"after {i} step{'s' * (i > 1)}")
        axes.plot(lengths.time, lengths.best, "-", color=INK, lw=2.2, label="optimised")
        for key in keys:
            axes.axvline(key.time, color=INK, lw=0.5, alpha=0.25)
        axes.set(xlabel="time [s]", ylabel="|q|", xlim=(lengths.time[0], lengths.time[-1]))
        axes.legend(frameon=False, loc="lower left")
        return _drawn(figure)
    finally:
        plt.close(figure)


@dataclass(frozen=True)
class Deviations:
    """Figure 10's curves, (10,) each by the path's name in STROKES, and what they are over the whole path.

    strong  mean |EL| (eq. 10); weak: what frames in the middles of segments promise, as a share of the raw spline's E
    """

    strong: dict[str, Array]
    weak: dict[str, Array]

    @classmethod
    def of(cls, keys: list[Frame]) -> Deviations:
        """The deviations of paths through orientations, with the paper's weights."""
        run = Run(keys)
        objective = run.solved(PAPER, 1).objective
        paths = {name: path for name, path in figure_ten(run, PAPER).items() if name in STROKES}
        raw = objective.value(paths["raw"])
        return cls(
            {name: strong_tenths(objective, path)["strong"] for name, path in paths.items()},
            {name: weak_tenths(objective, path) / raw for name, path in paths.items()},
        )

    def strong_mean(self, name: str) -> float:
        return float(self.strong[name].mean())

    def weak_sum(self, name: str) -> float:
        return float(self.weak[name].sum())

    @property
    def caption(self) -> str:
        strong = [self.strong_mean(name) for name in ("raw", "1", "3")]
        weak = [self.weak_sum(name) for name in ("raw", "1", "3")]
        return (
            "Euler-Lagrange deviation over equal tenths of paths through the keyframes of figure 7, with the paper's "
            "weights. Dotted: the raw spline; dashed: one variable frame between two keyframes; solid: three; "
            "dash-dotted: two in all, put where the deviation is largest. Left, as in the paper, the strong form, the "
            f"mean |EL| of eq. 10: over the whole path {_levels(strong, '{:.3g}')}{_verdict(strong)}. Right, the weak "
            "form, what one more frame in the middle of every segment would still gain, as a share of the raw "
            f"spline's E: {_levels(weak, '{:.2g}', percent=True)}{_verdict(weak)}. Two frames leave "
            f"{self.strong_mean(FEW) / strong[1]:.2g} times the strong form of one a segment; the paper's are nearly "
            "identical at the ends."
        )


def _levels(values: list[float], form: str, *, percent: bool = False) -> str:
    raw, one, three = (form.format(100 * value) + " %" if percent else form.format(value) for value in values)
    return f"{raw} raw, {one} with one frame, {three} with three"


def _verdict(values: list[float]) -> str:
    """The verdict on the paper's claim that the deviation decreases from the raw spline to one and three frames."""
    raw, one, three = values
    if raw > one > three:
        return ", in the order that the paper reports"
    return (
        ", not in the paper's order: it falls with the first frame and no further"
        if raw > one
        else (", not in the paper's order")
    )


def draw_deviations(deviations: Deviations) -> Picture:
    """Figure 10: the strong form and the weak one side by side."""
    figure, (first, right) = _sheet(2)
    try:
        _curves(first, deviations.strong, "strong form, as in the paper", "mean |EL|")
        _curves(right, deviations.weak, "weak form", "left to gain ÷ E of the raw spline")
        figure.legend(
            *first.get_legend_handles_labels(), loc="outside upper left", ncols=2, frameon=False, handlelength=4
        )
        return _drawn(figure)
    finally:
        plt.close(figure)


def _curves(axes: Axes, curves: dict[str, Array], title: str, label: str) -> None:
    axes.set_title(title, loc="left")
    for name, (stroke, words) in STROKES.items():
        axes.plot(np.arange(1, TENTHS + 1), curves[name], stroke, color=INK, lw=1.8, label=words)
    axes.set(xlabel="tenth of the path", ylabel=label, xticks=range(1, TENTHS + 1), yscale="log")


def _sheet(count: int) -> tuple[Figure, list[Axes]]:
    with plt.rc_context(style(10)):
        figure, axes = plt.subplots(1, count, figsize=(10, 4.4), dpi=DPI, layout="constrained", squeeze=False)
    return figure, list(axes[0])


def _drawn(figure: Figure) -> Picture:
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[:, :, :3].copy()
