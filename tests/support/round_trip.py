"""A motion written in a format and read back has the same qpos."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import wild

from dynsplines.exchange import formats
from dynsplines.exchange.motion_import import read_recording
from dynsplines.motion import Saved
from dynsplines.scene.configuration import quaternions

EXACT = 1e-6  # [m], [rad]


def check_round_trip(saved: Saved, kind: str, folder: Path, figure: str | None) -> None:
    """Up to the signs of quaternions, and at the same times."""
    target = formats.export(saved, kind, folder / f"out{formats.writer(kind).ending}")
    before, found = wild.samples(saved), read_recording(target, kind, figure=figure, fps=saved.fps)
    after = found.qpos.copy()
    assert after.shape == before.qpos.shape, kind
    for columns in quaternions(saved.figure.model).values():
        after[:, columns] *= np.sign(np.sum(after[:, columns] * before.qpos[:, columns], axis=1, keepdims=True))
    np.testing.assert_allclose(after, before.qpos, atol=EXACT, err_msg=kind)
    np.testing.assert_allclose(found.time - found.time[0], before.time - before.time[0], atol=1e-9)
