"""A figure drawn in a given shade: the main figure of a picture, or one of several."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Ghost:
    """One more figure in a picture, as in the paper's figure 6: keyframes darkest, in-betweens lightest.

    Attributes:
        qpos: The configuration, (nq,).
        shade: 0 for the model's colours, 1 for white.
        opacity: 0 for invisible, 1 for opaque.
    """

    qpos: NDArray[np.float64] = field(repr=False)
    shade: float = 0.0
    opacity: float = 1.0

    def __post_init__(self) -> None:
        for name, value in (("shade", self.shade), ("opacity", self.opacity)):
            if not 0.0 <= value <= 1.0:
                raise ValueError(f"{name} {value} of a ghost is not between 0 and 1")
        qpos = np.array(self.qpos, dtype=np.float64)
        qpos.setflags(write=False)
        object.__setattr__(self, "qpos", qpos)
