"""How people move between two keyframes: a prediction by small networks, trained on recordings. Not in the paper.

A network predicts the difference from spherical linear interpolation of the orientations of twelve parts of the body,
after B. N. Oreshkin et al., "Motion In-Betweening via Deep Δ-Interpolator", 2022. Here the difference is a sum of
sines, which vanish at the keyframes, and of the tangents of a cubic through the neighbouring keyframes, of which the
network chooses a share. All lengths are relative to the length of a leg.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ... import quaternion as quat
from ...array import Array, Index, Mask
from ...curve.symmetry import other_side

PARTS = (
    "pelvis", "chest", "left_upper_arm", "left_forearm", "right_upper_arm", "right_forearm",
    "left_thigh", "left_shin", "left_foot", "right_thigh", "right_shin", "right_foot",
)  # fmt: skip
PARENTS = (-1, 0, 1, 2, 1, 4, 0, 6, 7, 0, 9, 10)
TIPS = tuple(map(PARTS.index, ("left_forearm", "right_forearm", "left_foot", "right_foot")))  # end in wrists and toes
ANKLES = tuple(map(PARTS.index, ("left_foot", "right_foot")))  # the origins of feet
MIRRORED = [PARTS.index(other_side(part)) for part in PARTS]  # the part on the other side
SIDES = np.array([1.0, -1, 1])  # factors of positions in the mirror image; those of rotation vectors are −SIDES
MODES = 6  # number of sines, of half a period and its multiples per segment
OUTPUTS = 3 * MODES + 3  # of each part and of the hips: amplitudes, shares of two tangents, logarithm of a variance
HELD = 0.1  # [rad, 1] rotation of a part, or displacement of the hips, between keyframes below which it stays as it is
SOFT = 0.2  # [s] added to durations whose inverse is an input
Weights = Mapping[str, Array]


@dataclass(frozen=True, eq=False)
class Segments:
    """B pairs of keyframes a and b, with the keyframes before and after them. Missing ones repeat a or b.

    Rotations of parts are relative to a person who stands upright, faces x, and lets the arms hang.

    Attributes:
        hips: The midpoints of the hip joints above the ground, (B, 4, 3).
        turns: The orientations of the parts in the world, (B, 4, 12, 4).
        offsets: The origins of the parts in their parents, (B, 12, 3); the pelvis has its origin between the hips.
        tips: The wrists and toes in the parts `TIPS`, (B, 4, 3).
        gaps: The durations from each keyframe to the next, (B, 3) [s].
        is_known: Whether the first and the last keyframe exist, (B, 2).
        is_placed: Whether the keyframes specify the position of the hips, (B, 4).
        on_floor: Whether the height of the ground is known, (B,).
    """

    hips: Array
    turns: Array
    offsets: Array
    tips: Array
    gaps: Array
    is_known: Mask
    is_placed: Mask
    on_floor: Mask

    @cached_property
    def heading(self) -> Array:
        """The rotation of the pelvis in keyframe a about the vertical, (B, 4)."""
        w, z = self.turns[:, 1, 0, 0], self.turns[:, 1, 0, 3]
        return quat.from_rotation_vector(2 * np.arctan2(z, w)[:, None] * np.array([0.0, 0, 1]))

    @cached_property
    def mirrored(self) -> Segments:
        """The mirror images, with left and right exchanged."""
        turns = self.turns[:, :, MIRRORED] * [1.0, -1, 1, -1]
        offsets, tips = self.offsets[:, MIRRORED] * SIDES, self.tips[:, [1, 0, 3, 2]] * SIDES
        return replace(self, hips=self.hips * SIDES, turns=turns, offsets=offsets, tips=tips)

    @cached_property
    def steps(self) -> tuple[Array, Array]:
        """The rotation vectors (B, 3, 12, 3) and displacements of the hips (B, 3, 3) from keyframe to keyframe."""
        turns = quat.rotation_vector(quat.product(quat.conjugate(self.turns[:, :-1]), self.turns[:, 1:]))
        return turns, np.diff(self.hips, axis=1)

    @cached_property
    def features(self) -> Array:
        """The inputs of the network, (B, F)."""
        count, back = len(self.hips), quat.conjugate(self.heading)[:, None]
        turned = quat.matrices(quat.product(back[:, None], self.turns))[..., :2]
        joints, tips = places(self.turns, self.offsets[:, None], self.tips[:, None])
        ends = np.concatenate([tips, joints[:, :, ANKLES]], axis=2)
        placed = np.asarray(self.is_placed, float)
        hips = quat.rotate(back, self.hips - self.hips[:, 1:2]) * (placed * placed[:, 1:2])[..., None]
        heights = np.concatenate([self.hips[..., 2:], ends[:, :, 2:, 2] + self.hips[..., 2:]], axis=2)
        heights = heights * placed[..., None]
        floor = np.asarray(self.on_floor, float)[:, None]
        parts = turned, quat.rotate(back[:, None], ends), hips, self.steps[0]
        others = heights.reshape(count, -1) * floor, floor, self.is_known, placed, self.gaps, 1 / (self.gaps + SOFT)
        return np.concatenate([*(part.reshape(count, -1) for part in parts), *others], axis=1, dtype=float)

    @cached_property
    def bends(self) -> Array:
        """By how much the tangents of a cubic in a and b exceed those of linear interpolation, times the duration of
        the segment: rotation vectors of the parts, and displacements of the hips, (B, 2, 13, 3)."""
        steps = np.concatenate([self.steps[0], self.steps[1][:, :, None]], axis=2)
        before, at, after = (self.gaps[:, i, None, None] for i in range(3))
        rates = steps / np.maximum(self.gaps, 1e-9)[..., None, None]
        bends = np.stack(
            [(rates[:, 0] - rates[:, 1]) * at / (before + at), (rates[:, 2] - rates[:, 1]) * at / (at + after)], 1
        )
        return bends * self.is_known[..., None, None] * at[:, None]

    @cached_property
    def is_moved(self) -> Array:
        """Whether the parts and the hips move between keyframes a and b, as numbers between 0 and 1, (B, 13)."""
        square = np.sum(np.concatenate([self.steps[0][:, 1], self.steps[1][:, 1:2]], axis=1) ** 2, axis=2)
        return square / (square + HELD**2)

    def differences(self, outputs: Array, u: Array) -> Array:
        """Return the predicted differences from linear interpolation.

        Args:
            outputs: The outputs of the network, (B, 13, OUTPUTS).
            u: Phases in the segments, (B, P), from 0 to 1.

        Returns:
            Rotation vectors of the parts, in their axes, and displacements of the hips, (B, P, 13, 3).
        """
        amplitudes = outputs[..., : 3 * MODES].reshape(*outputs.shape[:2], MODES, 3)
        shares = 1 / (1 + np.exp(-outputs[..., 3 * MODES : 3 * MODES + 2]))
        tangents = shares.transpose(0, 2, 1)[..., None] * self.bends
        tangents[:, :, 12] = quat.rotate(quat.conjugate(self.heading)[:, None], tangents[:, :, 12])
        out = np.einsum("bpm,bjmc->bpjc", sines(u), amplitudes) + np.einsum("bpt,btjc->bpjc", cubics(u), tangents)
        out[:, :, 12] = quat.rotate(self.heading[:, None], out[:, :, 12])
        return out

    def poses(self, differences: Array, u: Array) -> tuple[Array, Array]:
        """Return hips (B, P, 3) and orientations (B, P, 12, 4) at phases u (B, P)."""
        (turns, moves), share = self.steps, u[..., None]
        hips = self.hips[:, 1:2] + share * moves[:, 1:2] + differences[:, :, 12]
        linear = quat.product(self.turns[:, 1:2], quat.from_rotation_vector(share[..., None] * turns[:, 1:2]))
        return hips, quat.product(linear, quat.from_rotation_vector(differences[:, :, :12]))


def sines(u: Array) -> Array:
    """Return the sines at phases u (...), (..., MODES)."""
    return np.sin(np.pi * u[..., None] * np.arange(1, MODES + 1))


def cubics(u: Array) -> Array:
    """Return the cubics whose derivatives are 1 in a and in b, and else zero, at phases u (...), (..., 2)."""
    return np.stack([u * (1 - u) ** 2, -(u**2) * (1 - u)], axis=-1)


def places(turns: Array, offsets: Array, tips: Array) -> tuple[Array, Array]:
    """Return the origins of the parts (..., 12, 3) and of wrists and toes (..., 4, 3) relative to the hips."""
    joints = [np.zeros((*turns.shape[:-2], 3))]
    for part, parent in enumerate(PARENTS[1:], start=1):
        joints.append(joints[parent] + quat.rotate(turns[..., parent, :], offsets[..., part, :]))
    ends = [joints[part] + quat.rotate(turns[..., part, :], tips[..., k, :]) for k, part in enumerate(TIPS)]
    return np.stack(joints, axis=-2), np.stack(ends, axis=-2)


def outputs_of(weights: Weights, features: Array) -> Array:
    """Return the outputs of a network, (B, 13, OUTPUTS), of features (B, F).

    Args:
        weights: "mean" and "std" of the features, and a matrix and a "bias" for each layer, by its number.
    """
    x = (features - weights["mean"]) / weights["std"]
    layers = sum(name.isdecimal() for name in weights)
    for layer in range(layers - 1):
        y = x @ weights[f"{layer}"].T + weights[f"{layer}.bias"]
        y = y / (1 + np.exp(-y))
        x = y if layer == 0 else x + y
    out = x @ weights[f"{layers - 1}"].T + weights[f"{layers - 1}.bias"]
    return out.reshape(len(features), 13, OUTPUTS)


@dataclass(frozen=True, eq=False)
class Prediction:
    """What several networks predict on average, for B segments at P phases.

    Attributes:
        hips: (B, P, 3).
        turns: The orientations of the parts, (B, P, 12, 4).
        expected: The squared errors that the networks expect, of the rotation of each part [rad²] and of the
            displacement of the hips, (B, 13).
        apart: The variances among the predictions, (B, 13).
        changes: The mean squared differences from linear interpolation, (B, 13).
    """

    hips: Array
    turns: Array
    expected: Array
    apart: Array
    changes: Array

    @classmethod
    def of(cls, networks: Sequence[Weights], segments: Segments, u: Array) -> Prediction:
        """Return the prediction for the segments and their mirror images at phases u (B, P), from 0 to 1."""
        differences, variances = [], []
        other_side = [*MIRRORED, 12]
        back = np.array([-SIDES] * 12 + [SIDES])
        for weights in networks:
            outputs, images = outputs_of(weights, segments.features), outputs_of(weights, segments.mirrored.features)
            mirrored = segments.mirrored.differences(images, u)[:, :, other_side] * back
            differences += [segments.differences(outputs, u), mirrored]
            variances += [np.exp(outputs[..., -1]), np.exp(images[:, other_side, -1])]
        apart = np.sum(np.var(differences, axis=0), axis=-1).max(axis=1)
        mean = np.mean(differences, axis=0) * segments.is_moved[:, None, :, None]
        changes = np.mean(np.sum(mean**2, axis=3), axis=1)
        return cls(*segments.poses(mean, u), np.mean(variances, axis=0), apart, changes)


def neighbours(count: int) -> tuple[Index, Mask]:
    """Return the keyframes of each of `count` segments (count, 4), and whether the outer two exist (count, 2)."""
    keys = np.arange(count)[:, None] + np.arange(-1, 3)
    return keys.clip(0, count), np.stack([keys[:, 0] >= 0, keys[:, 3] <= count], axis=1)
