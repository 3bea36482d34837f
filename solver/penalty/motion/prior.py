"""Prior: staying near the poses that people take between such keyframes. Not in the paper."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ... import quaternion as quat
from ...array import Array, Index, Mask, segments_at
from ...contacts.contact import Contact
from ...contacts.gait import GaitCycle
from ...curve.frame import Timeline
from ...curve.seam import Seam
from ...figure.algebra import cross
from ...figure.dynamics import Size
from ...figure.figure import Figure
from ...figure.kinematics import Samples
from ...figure.wrenches import every_axis, of_turn
from ..block import Block, every
from ..penalty import Normalization, Penalty
from .people import PARENTS, PARTS, TIPS, Prediction, Segments, Weights, neighbours

PHASES = 33  # number of phases per segment at which poses are predicted; in between they are interpolated
BRIEF, SHORT, LONG, ENDLESS = 0.2, 0.3, 1.5, 2.5  # [s] durations of segments between which trust rises, and falls
STANDS = 0.8  # [1] smallest height of the hips above the ankles at rest, relative to the length of a leg
SOLE = 0.06  # [1] height of the ankles above the ground in the recordings, relative to the length of a leg
REACH, TOE = 0.95, 0.16  # [1] lengths of a forearm relative to an upper arm, and of a foot relative to a leg
STIFF = 0.1  # [1] squared error of a part that does not move between keyframes, relative to the expected one
CLEAR = 0.2  # [1] squared differences from linear interpolation, relative to squared errors, at which trust is half
WORTH = 0.6e-3  # [rad⁻² s⁴] value that costs as much as angular accelerations of quaternions of 1 s⁻²
# parts of arms and legs, without feet, which hang in the zero pose
HANGING = [i for i, part in enumerate(PARTS) if part.endswith(("arm", "thigh", "shin"))]
FOREARMS = TIPS[:2]
DOWN, LATERAL = np.array([0.0, 0, -1]), np.array([0.0, 1, 0])


@dataclass(frozen=True, eq=False)
class Person:
    """The parts of a person among the links of a figure.

    Attributes:
        links: The links of the parts, (12,).
        turns: The orientations of the parts in their links, (12, 4): upright, facing x, with hanging arms if identity.
        middle: The midpoint of the hip joints in the link of the pelvis, (3,) [m].
        leg: The length of a leg [m].
        sole: The height of the ankles above the soles [m].
        offsets: The origins of the parts in their parents, (12, 3), relative to the length of a leg.
        tips: Wrists and toes in their parts, (4, 3), relative to the length of a leg.
    """

    figure: Figure
    links: Index
    turns: Array
    middle: Array
    leg: float
    sole: float
    offsets: Array
    tips: Array

    @classmethod
    def of(cls, figure: Figure, parts: Mapping[str, int], ground: float | None = None) -> Person:
        """Return the person of a figure that stands in its rest pose.

        Args:
            parts: The links by name of their part, see `people.PARTS`.
            ground: The height of the soles in the rest pose [m]; None: that of the recordings.

        Raises:
            ValueError: Parts are rigidly connected, the pelvis has no free joint, or the figure does not stand.
        """
        links, tables = np.array([parts[name] for name in PARTS]), figure.tables
        if np.unique(links).size < links.size:
            raise ValueError("some parts of the body have no joint between them")
        if links[0] not in tables.free_links:
            raise ValueError("the pelvis has no free joint")
        rest = Samples.of_qpos(figure)
        anchors, centres = rest.links.anchor[:, links, 0].T, rest.links.points(links, tables.centre[:, links])[0]
        in_links = rest.links.rotation[:, :, links, 0].transpose(2, 0, 1)
        to_left, middle = anchors[6] - anchors[9], 0.5 * (anchors[6] + anchors[9])
        heading = quat.from_rotation_vector(np.array([0.0, 0, np.arctan2(-to_left[0], to_left[1])]))
        bones = np.array([anchors[part + 1] - anchors[part] for part in range(11)])
        bones[[3, 5]] = (centres[..., 0].T - anchors)[[3, 5]]
        leg = float(np.linalg.norm(bones[6]) + np.linalg.norm(bones[7]))
        if middle[2] - anchors[[8, 11], 2].max() < STANDS * leg:
            raise ValueError("the figure does not stand in its rest pose")
        turns, back = np.tile(heading, (12, 1)), quat.conjugate(heading)
        for part in HANGING:
            turns[part] = quat.product(heading, quat.swing(DOWN, quat.rotate(back, bones[part]), LATERAL))
        origins = anchors.copy()
        origins[0] = middle
        steps = [origins[part] - origins[max(parent, 0)] for part, parent in enumerate(PARENTS)]
        offsets = quat.rotate(quat.conjugate(turns[[max(parent, 0) for parent in PARENTS]]), np.array(steps)) / leg
        arms = REACH * np.linalg.norm(bones[[2, 4]], axis=1) / leg
        toe = np.array([TOE, 0, -SOLE])
        tips = np.array([*(arms[:, None] * DOWN), toe, toe])
        sole = SOLE * leg if ground is None else float(anchors[[8, 11], 2].min() - ground)
        matrices = np.einsum("pji,pjk->pik", in_links, quat.matrices(turns))
        in_own = np.array([quat.from_matrix(matrix) for matrix in matrices])
        return cls(figure, links, in_own, in_links[0].T @ (middle - anchors[0]), leg, sole, offsets, tips)

    @property
    def quaternions(self) -> Index:
        """The columns of the orientations of the parts in the state, (12, 4); −1 for those that are no entries."""
        tables, out = self.figure.tables, np.full((12, 4), -1)
        columns = dict(zip(tables.quaternion_links.tolist(), tables.quaternion_columns.T, strict=True))
        for part, link in enumerate(self.links.tolist()):
            if link in columns and tables.in_world[link]:
                out[part] = columns[link]
        return out

    @property
    def is_robot(self) -> bool:
        """Whether the parts have hinges."""
        return bool((self.quaternions < 0).any())

    @property
    def position(self) -> Index:
        """The columns of the position of the pelvis in the state, (3,)."""
        return self.figure.links[int(self.links[0])].qpos + np.arange(3)

    def is_specified(self, keys: Timeline) -> Mask:
        """Return whether both keyframes of each segment specify the predicted entries, (K − 1, 51): none without the
        position of the pelvis."""
        columns = self.quaternions.ravel()
        turns = np.where(columns >= 0, keys.known[:, columns], keys.known.all(axis=1, keepdims=True))
        specified = np.concatenate([keys.known[:, self.position], turns], axis=1)
        specified &= keys.known[:, self.position].all(axis=1, keepdims=True)
        return specified[:-1] & specified[1:]

    def is_unattached(self, keys: Timeline, contacts: Sequence[Contact]) -> Mask:
        """Return which predicted entries of each segment are not those of an arm that approaches, holds or leaves a
        contact, (K − 1, 51)."""
        out = np.ones((keys.times.size - 1, 3 + 4 * len(PARTS)), bool)
        for contact in contacts:
            is_near = (keys.times[1:] >= contact.first) & (keys.times[:-1] <= contact.last)
            for forearm in FOREARMS:
                if self.figure.tables.path[contact.point.link, self.links[forearm]]:
                    for part in (PARENTS[forearm], forearm):  # behind the 3 entries of the hips
                        out[is_near, 3 + 4 * part : 7 + 4 * part] = False
        return out

    def posture(self, states: Array, ground: float) -> tuple[Array, Array]:
        """Return hips (..., 3), relative to the length of a leg, and orientations (..., 12, 4) of states (..., N)."""
        motion = Samples.still(self.figure, states.reshape(-1, states.shape[-1])).links
        rotations = quat.normalise(motion.Q[:, self.links].transpose(2, 1, 0)).reshape(*states.shape[:-1], 12, 4)
        hips = states[..., self.position] + quat.rotate(rotations[..., 0, :], self.middle)
        return (hips - self._floor(ground)) / self.leg, quat.product(rotations, self.turns)

    def states(self, hips: Array, turns: Array, ground: float) -> tuple[Array, Array]:
        """Return the positions of the pelvis (..., 3) [m] and orientations of the links (..., 12, 4) of a posture."""
        rotations = quat.product(turns, quat.conjugate(self.turns))
        return self.leg * hips + self._floor(ground) - quat.rotate(rotations[..., 0, :], self.middle), rotations

    def _floor(self, ground: float) -> Array:
        """The point (3,) [m] on the ground, below which ankles are as high as in the recordings."""
        return np.array([0.0, 0.0, ground + self.sole - SOLE * self.leg])


@dataclass(frozen=True, eq=False)
class Prior(Penalty):
    """Σ w (x − x̂)² + Σ w |q − q̂|² over predicted positions x̂ and orientations q̂ of links [1].

    The sum is about 1 where the motion differs from the prediction by its expected error, and the prediction is clear.

    Attributes:
        times: The times of the keyframes, (K,) [s].
        positions: The columns of the predicted positions, (p,).
        links: The links of the predicted orientations, (n,).
        quaternions: The columns of these orientations, (n, 4); −1 for those that are no entries of the state.
        predicted: The predicted entries at P equal distances in each segment, (K − 1, P, p + 4 n).
        weights: The weights w of the predicted entries in each segment, (K − 1, p + 4 n) [1/m², 1].
    """

    times: Array
    positions: Index
    links: Index
    quaternions: Index
    predicted: Array
    weights: Array

    name = "prior"
    normalization = Normalization(WORTH, normalize_by="acceleration.angular")

    @classmethod
    def of(
        cls,
        person: Person,
        keys: Timeline,
        networks: Sequence[Weights],
        ground: float | None = None,
        cycle: GaitCycle | None = None,
        contacts: Sequence[Contact] = (),
    ) -> Prior:
        """Return the prior of a timeline of keyframes.

        A part of the body has weight only between keyframes that specify it.

        Args:
            networks: The weights of the networks, see `people.outputs_of`.
            ground: The height of level ground [m]; None: it is unknown.
            cycle: The gait cycle that the motion approaches; None: there is none. It lowers the weights.
            contacts: The specified contacts. The networks ignore what hands touch, so their arms have no weight.
        """
        segments = _segments(person, keys, ground)
        count, floor = len(segments.hips), ground or 0.0
        phases = np.tile(np.linspace(0, 1, PHASES), (count, 1))
        prediction, (power, factor) = Prediction.of(networks, segments, phases), networks[0]["calibration"]
        positions, rotations = person.states(prediction.hips, prediction.turns, floor)
        variances = prediction.expected * segments.gaps[:, 1:2] ** power + factor * prediction.apart
        clearness = prediction.changes[:, :12].sum(axis=1) / variances[:, :12].sum(axis=1)
        trust = np.interp(segments.gaps[:, 1], [BRIEF, SHORT, LONG, ENDLESS], [0, 1, 1, 0])
        trust *= clearness**3 / (clearness**3 + CLEAR**3)
        if cycle is not None:
            trust /= 1 + cycle.mean_trust(keys.times)
        weights = trust[:, None] / (13 * variances * np.maximum(segments.is_moved, STIFF))
        by_entry = [np.repeat(weights[:, 12:] / person.leg**2, 3, axis=1), np.repeat(4 * weights[:, :12], 4, axis=1)]
        values = np.concatenate([positions, rotations.reshape(count, PHASES, 48)], axis=2)
        weights = np.concatenate(by_entry, axis=1) * person.is_specified(keys) * person.is_unattached(keys, contacts)
        return cls(keys.times, person.position, person.links, person.quaternions, values, weights)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        (expected, weights), first = self._at(samples.t), self.positions.size
        turned, by_link = (part[:, first:].reshape(samples.count, -1, 4) for part in (expected, weights))
        turned = turned / np.linalg.norm(turned, axis=2, keepdims=True)
        is_entry = self.quaternions[:, 0] >= 0
        columns = np.concatenate([self.positions, self.quaternions[is_entry].ravel()])
        y = samples.y[:, columns]
        sign = np.sign(np.einsum("spi,spi->sp", turned[:, is_entry], y[:, first:].reshape(samples.count, -1, 4)))
        entries = (turned[:, is_entry] * sign[..., None]).reshape(samples.count, -1)
        weight = np.concatenate([weights[:, :first], by_link[:, is_entry].reshape(samples.count, -1)], axis=1)
        yield every(samples, columns, 0, y - np.concatenate([expected[:, :first], entries], axis=1), weight)
        if not is_entry.all():
            yield from _of_axes(samples, self.links[~is_entry], turned[:, ~is_entry], by_link[:, ~is_entry, 0])

    def _at(self, t: Array) -> tuple[Array, Array]:
        """Return predicted entries and their weights at times t (S,) [s], (S, p + 4 n) each."""
        segment, last = segments_at(self.times, t), self.predicted.shape[1] - 1
        place = (t - self.times[segment]) / np.diff(self.times)[segment] * last
        first = np.minimum(place.astype(int), last - 1)
        share, before, after = place - first, self.predicted[segment, first], self.predicted[segment, first + 1]
        return before + share[:, None] * (after - before), self.weights[segment]


def _of_axes(samples: Samples, links: Index, expected: Array, weights: Array) -> Iterator[Block]:
    """Return the differences of links' axes from those of expected orientations (S, n, 4). Their squares sum up to
    twice the squared angle, and |q − q̂|² is a quarter of it, so weights (S, n) are divided by 8."""
    at, link, along = every_axis(links, samples.count)
    axes = quat.matrices(expected).transpose(2, 3, 1, 0)
    for k in range(3):
        turned = samples.links.rotation[:, k, links]
        changes = of_turn(at, link, cross(np.tile(turned.reshape(3, -1), 3), along))
        yield Block(at, (turned - axes[:, k]).ravel(), (changes,), np.tile(weights.T.ravel() / 8, 3))


def _segments(person: Person, keys: Timeline, ground: float | None) -> Segments:
    """Return the segments of a timeline. Those at the seam of a loop have neighbours across it."""
    places, has_neighbours = neighbours(keys.times.size - 1)
    states, gaps = keys.states[places], np.diff(keys.times[places], axis=1)
    if keys.ends == "periodic":
        seam = Seam.of(person.figure, keys)
        states[0, 0], states[-1, 3] = seam.move(keys.states[-2], -1), seam.move(keys.states[1], 1)
        gaps[0, 0], gaps[-1, 2], has_neighbours = gaps[-1, 1], gaps[0, 1], np.ones_like(has_neighbours)
    hips, turns = person.posture(states, ground or 0.0)
    count = len(hips)
    offsets, tips = (np.tile(part, (count, 1, 1)) for part in (person.offsets, person.tips))
    is_placed: Mask = np.asarray(keys.known[places][..., person.position].all(axis=2))
    on_floor = np.full(count, ground is not None)
    return Segments(hips, turns, offsets, tips, gaps / Size.of(person.figure).time, has_neighbours, is_placed, on_floor)
