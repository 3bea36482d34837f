"""Somebody kneels: one foot stands on its toe, whose heel slowly rises; the other stands flat. All of it is known."""

from __future__ import annotations

import numpy as np
from faulted import Take

from dynsplines.clip import load as clips
from dynsplines.scene.compose import compose, figure_spec

SECONDS, RISES_FROM, RISES_UNTIL = 3.2, 0.7, 2.3  # [s]
DROP, FORWARD = 0.25, 0.05  # [m] of the root
TOE = np.array([0.17, -0.061])  # [m] centre of the round tip of the sole from the ankle: x and z


def kneeling(fps: float, pitch: float) -> Take:
    """The human on the left sole and the right toe, whose centres stay; the right foot ends with this pitch [rad]."""
    scene = compose(figure_spec("human"))
    figure = clips.figure_of(scene, "kneeling")
    model = figure.model
    time = np.arange(round(SECONDS * fps) + 1) / fps
    share = np.clip((time - RISES_FROM) / (RISES_UNTIL - RISES_FROM), 0, 1)
    share = share**3 * (10 - 15 * share + 6 * share**2)
    qpos = np.tile(model.qpos0, (time.size, 1))
    qpos[:, 0] += FORWARD * share
    qpos[:, 2] -= DROP * share
    thigh, shin = (-float(model.body(f"left_{below}").pos[2]) for below in ("shin", "foot"))
    for side, tilt in (("left", 0 * share), ("right", pitch * share)):
        ankle = np.array([[0.0], [-thigh - shin]]) + TOE[:, None] - _turned(TOE[:, None], tilt)
        leg = ankle - np.array([FORWARD * share, -DROP * share])
        knee = np.pi - np.arccos((thigh**2 + shin**2 - np.sum(leg**2, axis=0)) / (2 * thigh * shin))
        bent = np.array([-shin * np.sin(knee), -thigh - shin * np.cos(knee)])
        hip = np.arctan2(leg[0], leg[1]) - np.arctan2(bent[0], bent[1])
        hip = np.arctan2(np.sin(hip), np.cos(hip))
        for joint, angle in (("hip", hip), ("knee", knee), ("ankle", tilt - hip - knee)):
            at = model.joint(f"{side}_{joint}").qposadr[0]
            qpos[:, at], qpos[:, at + 2] = np.cos(angle / 2), np.sin(angle / 2)
    return Take(figure, time, qpos)


def _turned(place: np.ndarray, angle: np.ndarray) -> np.ndarray:
    """x and z (2, T) turned about y by angles (T,) [rad]."""
    return np.array(
        [place[0] * np.cos(angle) + place[1] * np.sin(angle), place[1] * np.cos(angle) - place[0] * np.sin(angle)]
    )
