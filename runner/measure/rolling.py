"""How far a round foot rolls: what its middle moves while nothing of it slips."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from dynsplines.solver.array import Array
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Rest

UP = np.array([0.0, 0, 1])


@dataclass(frozen=True, eq=False)
class Rolling:
    """A sphere of a link on a plane.

    arm   (3,) [m] from what of the sphere is lowest to its middle
    from_ (3, 3) how the link is turned where the sphere's middle counts as in its place
    """

    arm: Array
    from_: Array

    @classmethod
    def of(cls, rest: Rest, samples: Samples, at: int = 0) -> Rolling | None:
        """That of a rest that rolls, in its place at one of the samples; None for others."""
        if not rest.rolls:
            return None
        up = UP if rest.ground is None else rest.ground.normal
        return cls(rest.point.radius * up, samples.links.rotation[:, :, rest.point.link, at])

    def way(self, rotation: Array) -> Array:
        """(3, k) [m] that the middle goes if the link turns to (3, 3, k) about one axis all the time."""
        turned = Rotation.from_matrix(np.moveaxis(rotation, -1, 0) @ self.from_.T).as_rotvec()
        return np.cross(turned, self.arm).T
