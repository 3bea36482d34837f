"""Curves through keyframes before any search: the raw spline of keyframes, and the straight path between them.

On the raw spline, the signs of quaternions determine the direction in which a joint turns between keyframes, its
winding. A joint takes the shortest arc *relative to its parent*. Near a half turn of the whole figure, a limb's
shortest arc in the world may be opposite to its parent's, which would tear the limb off. A free body also takes the
shortest arc, unless that is nearly a half turn. Then it turns in the direction that changes its angular velocity least,
so that a spinning body continues to spin.

On the straight path, each joint turns by one arc at constant speed (SLERP, K. Shoemake 1985), and positions are
interpolated linearly. The path is not smooth, but no limb leaves the region between its poses. It is an alternative
start for a search where the spline through the keyframes overshoots too far.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from .. import quaternion as quat
from ..array import Array, Mask, segments_at
from ..figure.figure import Figure, JointKind, Link, quaternion_columns
from ..tolerances import ROUNDING, TINY
from .frame import Frame, Timeline, TimelineError
from .seam import Seam, close_loop, sameness
from .spline import Sampling, Spline, natural_end_slopes

NEARLY_HALF = np.radians(150.0)  # [rad] angle above which a free body's direction of rotation is ambiguous


def raw_timeline(
    figure: Figure,
    keys: list[Frame],
    ends: str = "free",
    end_slope: Array | None = None,
    travel: ArrayLike | None = None,
    turn: float | None = None,
) -> Timeline:
    """Return the keyframes' timeline in the figure's coordinates, with the natural spline's end slopes (method of §2).

    Signs of quaternions are chosen so that joints turn by the shortest arcs. Unspecified degrees of freedom start where
    they were posed, otherwise on the natural spline through the other keyframes (of rotations relative to the parent),
    or at the rest pose if no keyframe specifies them. In a loop, entries that the first or the last keyframe fixes are
    fixed in both.

    Args:
        keys: Keyframes that hold *qpos* and the fixed mask, in order of time.
        ends: "free", "clamped", "clamped start", "clamped end" or "periodic", see `Timeline`.
        end_slope: The slopes of clamped ends, (2, N); the row of a free end is ignored.
        travel: Displacement of a loop's root over one period, (3,) [m]; None: x and y from the keyframes.
        turn: Rotation of a loop's root about the vertical over one period [rad]; None: from the keyframes.

    Raises:
        TimelineError: The keyframes are invalid, or end_slope, travel or turn do not match the ends.
    """
    _check(figure, keys)
    seam = None
    if ends == "periodic" and len(keys) > 1:
        keys, seam = close_loop(figure, keys, travel, turn)
    elif travel is not None or turn is not None:
        name = "travel" if travel is not None else "turn"
        raise TimelineError(f"{name} is for ends = 'periodic', not '{ends}'")
    plain = Timeline(tuple(keys), np.zeros((2, figure.width)))
    states = np.array(plain.states)
    rest = np.array(figure.model.qpos0)
    specified, samplings = plain.known, dict[bytes, Sampling]()
    for link in figure.links[1:]:
        if link.kind is JointKind.FREE:
            for column in range(link.qpos, link.qpos + 3):
                _fill(plain.times, states, specified, slice(column, column + 1), rest, samplings)
        columns = quaternion_columns(link)
        if columns is None:
            _fill(plain.times, states, specified, slice(link.qpos, link.qpos + 1), rest, samplings)
            continue
        fixed = specified[:, columns].all(axis=1)
        base = bases(figure, states, link)
        states[fixed, columns] = quat.product(base[fixed], quat.normalise(states[fixed, columns]))
        if not fixed.all():
            relative = quat.product(quat.inverse(base), states[:, columns])
            relative[fixed] *= signs(plain.times[fixed], relative[fixed], spins=link.kind is JointKind.FREE)[:, None]
            states[:, columns] = relative
            _fill(plain.times, states, specified, columns, rest, samplings)
            states[:, columns] = quat.product(base, quat.normalise(states[:, columns]))
        if seam is not None and link.kind is JointKind.FREE:
            states[-1, columns] = seam.linear(states[0])[columns]
        elif seam is not None:  # relative to its parent, the last rotation is the first
            states[-1, columns] = quat.product(base[-1], quat.product(quat.inverse(base[0]), states[0, columns]))
        states[:, columns] = _signed_track(link, plain.times, base, states[:, columns])
    if seam is not None:
        lifted = Seam.with_headings(figure, states[0], states[-1], seam.headings)
        states[-1] = lifted.linear(states[0]) + seam.shift
    frames = tuple(Frame.many(plain.times, states, plain.fixed, [key.posed for key in keys]))
    return Timeline(frames, _end_slope(figure, keys, states, ends, end_slope), ends)


def _end_slope(figure: Figure, keys: list[Frame], states: Array, ends: str, clamped: Array | None) -> Array:
    """Return the rows (2, N) below the frames' states, for any ends."""
    times = np.array([frame.time for frame in keys])
    if ends == "periodic":
        return Seam.between(figure, states[0], states[-1]).jumps(Spline(times, ends), states)
    natural = natural_end_slopes(times, states)
    if not ends.startswith("clamped"):
        return natural
    shape = None if clamped is None else np.shape(clamped)
    if clamped is None or shape != (2, figure.width):
        raise TimelineError(f"clamped ends need end_slope of shape (2, {figure.width}), not {shape}")
    # the slope of a quaternion changes sign with it
    rest = np.array(figure.model.qpos0)
    as_given = [figure.to_state(np.where(keys[i].known, keys[i].state, rest)) for i in (0, -1)]
    signs = [sameness(figure, a, b) for a, b in zip(as_given, states[[0, -1]], strict=True)]
    slopes = np.asarray(clamped, float) * signs
    free = Timeline(tuple(keys), slopes, ends).free_slopes
    return np.where(np.array(free)[:, None], natural, slopes)


def bases(figure: Figure, states: Array, link: Link) -> Array:
    """Return the left factor (K, 4) of a joint's relative rotation in the figure's coordinates, for states (K, N)."""
    identity = np.tile([1.0, 0, 0, 0], (len(states), 1))
    if link.kind is JointKind.FREE or not figure.tables.in_world[link.joint + 1]:
        return identity
    parent = quaternion_columns(figure.links[link.parent])
    return quat.product(identity if parent is None else states[:, parent], link.turn)


def _signed_track(link: Link, times: Array, base: Array, track: Array) -> Array:
    """Return a track (K, 4) with the signs of the joint's winding, base⁻¹ ⊗ track."""
    relative = quat.product(quat.inverse(base), track)
    return track * signs(times, relative, spins=link.kind is JointKind.FREE)[:, None]


def _fill(
    times: Array, states: Array, specified: Mask, columns: slice, rest: Array, samplings: dict[bytes, Sampling]
) -> None:
    """Fill columns at the frames that do not specify them, from the natural spline through the others. Beyond the
    ends of that spline the values are constant.

    Args:
        samplings: The samplings of such splines by the frames that specify them, extended if one is missing.
    """
    known: Mask = np.asarray(specified[:, columns].all(axis=1))
    if known.all():
        return
    if known.sum() < 2:
        states[~known, columns] = states[known, columns] if known.any() else rest[columns]
        return
    t, values, key = times[known], states[known, columns], known.tobytes()
    between = ~known & (times > t[0]) & (times < t[-1])
    if key not in samplings:
        samplings[key] = Sampling.of(Spline(t), times[between])
    states[between, columns] = samplings[key].samples(np.concatenate([values, natural_end_slopes(t, values)]))[0]
    states[times < t[0], columns], states[times > t[-1], columns] = values[0], values[-1]


def _check(figure: Figure, keys: list[Frame]) -> None:
    """Raise TimelineError for keyframes that do not match the figure."""
    columns = figure.tables.quaternion_columns
    if all(frame.state.size == figure.width for frame in keys):
        fixed = np.array([frame.fixed for frame in keys], bool).reshape(-1, figure.width)[:, columns]
        specified = np.array([frame.known for frame in keys], bool).reshape(-1, figure.width)[:, columns]
        q = np.array([frame.state for frame in keys]).reshape(-1, figure.width)[:, columns]
        is_specified = specified.all(axis=1)
        whole = all(np.array_equal(mask.all(axis=1), mask.any(axis=1)) for mask in (fixed, specified))
        if whole and np.all(np.einsum("kin,kin->kn", q, q)[is_specified] > TINY):
            return
    for number, frame in enumerate(keys, start=1):
        _check_masks(figure, frame, number)


def _check_masks(figure: Figure, frame: Frame, number: int) -> None:
    place = f"keyframe {number} (t = {frame.time:g} s)"
    if frame.state.size != figure.width:
        raise TimelineError(f"{place}: {frame.state.size} entries, the figure's qpos has {figure.width}")
    for link in figure.links[1:]:
        columns = quaternion_columns(link)
        if columns is None:
            continue
        mask = frame.known[columns]
        if any(entries[columns].any() and not entries[columns].all() for entries in (frame.fixed, frame.known)):
            raise TimelineError(
                f"{place}: the quaternion of '{link.name}' is fixed in part; fix all four of its components or none"
            )
        if mask.all() and not np.linalg.norm(frame.state[columns]) > ROUNDING:
            raise TimelineError(f"{place}: the quaternion of '{link.name}' is zero")


def signs(times: Array, relative: Array, *, spins: bool) -> Array:
    """Return the signs of a joint's quaternions; that of the first is +1.

    Args:
        times: Times of the keyframes, (K,) [s].
        relative: Quaternions relative to the parent, of any length > 0, (K, 4).
        spins: Whether the joint is a free body's, which may turn by more than a half turn.

    Returns:
        ±1, (K,).
    """
    same = np.einsum("ki,ki->k", relative[1:], relative[:-1]) >= 0
    if not spins:
        return np.append(1.0, np.cumprod(np.where(same, 1.0, -1.0)))
    steps = quat.rotation_vector(quat.product(quat.inverse(relative[:-1]), relative[1:]))
    angle = np.linalg.norm(steps, axis=1)
    longer = np.zeros(angle.size, bool)
    is_ambiguous = angle > NEARLY_HALF
    if is_ambiguous.any():
        longer = _steadiest(times, steps, angle, is_ambiguous)
    return np.append(1.0, np.cumprod(np.where(same != longer, 1.0, -1.0)))


def _steadiest(times: Array, steps: Array, angle: Array, unsure: Mask) -> Mask:
    """Return which ambiguous segments take the longer arc: the least Σ |Δω|²/Δt over all choices, by recursion.

    Args:
        times: (K,) [s].
        steps: The shortest arcs, (K − 1, 3) [rad], in the joint's own axes at either end of a segment.
        angle: Their angles, (K − 1,) [rad].
        unsure: The ambiguous segments, (K − 1,).
    """
    spans = np.diff(times)
    rates = np.stack([steps, steps - 2 * np.pi * steps / np.maximum(angle, ROUNDING)[:, None]], axis=1)
    rates /= spans[:, None, None]
    cost = np.array([0.0, 0.0 if unsure[0] else np.inf])
    previous = np.zeros((spans.size, 2), int)
    for k in range(1, spans.size):
        change = rates[k][None, :] - rates[k - 1][:, None]
        by_choice = cost[:, None] + 2 * np.einsum("abi,abi->ab", change, change) / (spans[k] + spans[k - 1])
        previous[k] = by_choice.argmin(axis=0)
        cost = by_choice.min(axis=0)
        if not unsure[k]:
            cost[1] = np.inf
    choice = np.zeros(spans.size, int)
    choice[-1] = int(cost[1] < cost[0])
    for k in range(spans.size - 1, 0, -1):
        choice[k - 1] = previous[k, choice[k]]
    return choice > 0


def straighten(figure: Figure, timeline: Timeline) -> Timeline:
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
            joint = quat.normalise(quat.product(quat.inverse(bases(figure, states, link)), states[:, columns]))
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
    return quat.normalise(first[:, None] * a + second[:, None] * b)
