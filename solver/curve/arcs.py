"""The straight way between keyframes: joints turn by one arc at one speed (SLERP, K. Shoemake 1985), positions go along
lines. It is as far from smooth as can be, but no limb leaves what lies between its poses: a second place to begin from
where the spline through the keyframes swings so far that the search does not find back.
"""

from __future__ import annotations

import numpy as np

from .. import quaternion as quat
from ..array import Array
from ..figure.figure import Figure, quaternion_columns
from .frame import Timeline
from .unknowns import bases

PARALLEL = 1e-9  # sine of an angle below which an arc is a line


def straightened(figure: Figure, timeline: Timeline) -> Timeline:
    """The timeline with its variable frames on the straight way between the frames beside them of which something is
    fixed; joints turn relative to their parents, the way round that the states' signs say."""
    given = np.flatnonzero(timeline.fixed.any(axis=1))
    if given.size < 2:
        return timeline
    states = straight(figure, timeline.times[given], timeline.states[given], timeline.times)
    rows = np.array(timeline.rows)
    moved = np.setdiff1d(np.arange(given[0], given[-1]), given)
    rows[moved] = states[moved]
    if timeline.ends == "free":
        for end, (a, b) in enumerate(((0, 1), (-2, -1))):
            rows[end - 2] = (rows[:-2][b] - rows[:-2][a]) / (timeline.times[b] - timeline.times[a])
    return timeline.with_rows(rows)


def straight(figure: Figure, times: Array, states: Array, t: Array) -> Array:
    """(T, N): the states (K, N) at times (K,) [s] joined by straight ways, at times t (T,) [s]."""
    span = np.clip(np.searchsorted(times, t, side="right") - 1, 0, times.size - 2)
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
    """(T, 4): unit quaternions a share of the way from a (T, 4) to b (T, 4), the longer way round where a·b < 0."""
    angle = np.arccos(np.clip(np.einsum("ti,ti->t", a, b), -1, 1))
    sine = np.sin(angle)
    flat = sine < PARALLEL
    divisor = np.where(flat, 1.0, sine)
    first = np.where(flat, 1 - share, np.sin((1 - share) * angle) / divisor)
    second = np.where(flat, share, np.sin(share * angle) / divisor)
    return quat.normalised(first[:, None] * a + second[:, None] * b)
