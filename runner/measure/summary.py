"""A short summary of a solve, with its violations, without measurements that take long."""

from __future__ import annotations

from collections.abc import Sequence

from ..motion import Saved
from .violation import Violation, plain


def summary(saved: Saved, violations: Sequence[Violation]) -> dict[str, object]:
    """Return plain numbers for JSON, with the objective and the data on the search that the file stores."""
    times, trace = saved.timeline.times, saved.trace
    values = {"objective before": trace[0][2], "objective": trace[-1][2]} if trace else {}
    return {
        "clip": saved.name,
        "duration, s": float(times[-1] - times[0]),
        "keyframes": len(saved.keys),
        "partial keyframes": sum(not key.is_key for key in saved.keys),
        "variable frames": saved.timeline.variable_count,
        **values,
        **saved.search,
        "violations": plain(violations),
    }
