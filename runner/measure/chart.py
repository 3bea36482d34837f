"""The chart of a motion's measured amounts, relative to the bounds of violations."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from ..system.output import Replacement
from .measurement import Measurement

ENDINGS = (".png", ".svg", ".pdf")
INK = "#22303a"
LEAST = 0.1  # [1] least amount of a drawn kind, relative to its bound


def style(size: float) -> dict[Any, Any]:
    """Return the style of charts: open at the top and on the right, text of a size [points]."""
    return {"axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": INK, "font.size": size}


def draw(name: str, before: Measurement, after: Measurement, target: Path) -> None:
    """Write a chart of the amounts of all kinds of violations before and after, completely or not at all."""
    sides = [side.by_kind(relative=True) for side in (before, after)]
    kinds = [kind for kind in sides[0] | sides[1] if max(side[kind].max() for side in sides if kind in side) >= LEAST]
    with plt.rc_context(style(9)):
        figure, axes = plt.subplots(figsize=(12, 4.5), layout="constrained")
        try:
            axes.set_title(f"{name}: before (dashed) and after", loc="left", parse_math=False)
            for k, kind in enumerate(kinds):
                for motion, amounts, stroke in zip((before, after), sides, ("--", "-"), strict=True):
                    values = amounts.get(kind, np.zeros(motion.time.size))
                    label = kind if motion is after else None
                    axes.plot(motion.time, values, stroke, color=f"C{k % 10}", lw=1.2, label=label)
            axes.axhline(1, color=INK, lw=0.8)
            for time in after.time[after.key_at]:
                axes.axvline(time, color=INK, lw=0.5, alpha=0.25)
            axes.set(xlabel="time [s]", ylabel="amount / bound of a violation", ylim=(0, None))
            if kinds:
                axes.legend(frameon=False, ncols=2)
            with Replacement(target) as temporary:
                figure.savefig(temporary, dpi=120, format=target.suffix[1:].lower())
        finally:
            plt.close(figure)
