"""The straight path between keyframes: each joint turns by one arc at constant speed (SLERP, K. Shoemake 1985), and
positions are interpolated linearly. The path is not smooth, but no limb leaves the region between its poses. It is an
alternative start for a search where the spline through the keyframes overshoots too far.
"""

from __future__ import annotations

import numpy as np

from .. import quaternion as quat
from ..array import Array, segments_at
from ..figure.figure import Figure, quaternion_columns
from ..tolerances import ROUNDING
from .frame import Timeline
from .unknowns import bases


def straightened(figure: Figure, timeline: Timeline) -> Timeline:
    """Return the timeline with its variable frames on the straight path between neighbouring frames with fixed entries.

    Joints turn relative to their parents; the signs of the quaternions determine the direction.
    """
    fixed = np.flatnonzero(timeline.fixed.any(axis=1))
    if fixed.size < 2:
        return timeline
    states = straight(figure, timeline.times[fixed], timeline.states[fixed], timeline.times)
    rows = np.array(timeline.rows)
    moved = np.setdiff1d(np.arange(fixed[0], fixed[-1]), fixed)
    rows[moved] = states[moved]
    for end, (a, b) in enumerate(((0, 1), (-2, -1))):
        if timeline.free_slopes[end]:
            rows[end - 2] = (rows[:-2][b] - rows[:-2][a]) / (timeline.times[b] - timeline.times[a])
    return timeline.with_rows(rows)


def straight(figure: Figure, times: Array, states: Array, t: Array) -> Array:
    """Return states (T, N) at times t (T,) [s] on the straight path through states (K, N) at times (K,) [s]."""
    span = segments_at(times, t)
    share = np.clip((t - times[span]) / (times[span + 1] - times[span]), 0, 1)
    out = states[span] + share[:, None] * (states[span + 1] - states[span])
    for link in figure.links[1:]:
        columns = quaternion_columns(link)
        if columns is not None:
            joint = quat.normalised(quat.product(quat.inverse(bases(figure, states, link)), states[:, columns]))
            turned = _arc(joint[span], joint[span + 1], share)
            out[:, columns] = quat.product(bases(figure, out, link), turned)
    return out


def _arc(a: Array, b: Array, share: Array) -> Array:
    """Return unit quaternions (T, 4) at a share (T,) of the arc from a to b (T, 4), the longer arc where a·b < 0."""
    angle = np.arccos(np.clip(np.einsum("ti,ti->t", a, b), -1, 1))
    sine = np.sin(angle)
    flat = sine < ROUNDING
    divisor = np.where(flat, 1.0, sine)
    first = np.where(flat, 1 - share, np.sin((1 - share) * angle) / divisor)
    second = np.where(flat, share, np.sin(share * angle) / divisor)
    return quat.normalised(first[:, None] * a + second[:, None] * b)
