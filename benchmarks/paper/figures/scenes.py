"""Figures 6, 7, 11 and 12: a figure's keyframes, and what is between them, in its scene."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from dynsplines.motion import Saved, continuous
from dynsplines.picture.camera import ANGLES, View, still
from dynsplines.picture.graphics import Graphics
from dynsplines.picture.show import Look, figure_height, figure_six
from dynsplines.picture.stage import Ghost, Stage
from dynsplines.scene.framing import middles
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.spline import path_of
from paper.penetration import Penetration, penetration

from .captioned import Picture

WIDTH = 1600  # [pixels]
TALL, FLAT = 640, 440  # [pixels] for people, and for a path alone
BETWEEN_RATE = 8.0  # [1/s] of figure 7: few enough that each can be seen
LOOK_RATE = 500.0  # [1/s] of the look for what is deepest
KEY_SHADE, KEY_OPACITY = 0.3, 0.45  # of keyframes beside a sample
CLOSE, CLOSE_ASPECT = 0.38, 4 / 3  # the close-up's height as a share of the picture's, and its shape
CLOSE_DISTANCE, CLOSE_ELEVATION = 1.1, -14.0  # [m], [degrees] of its camera
BORDER = 3  # [pixels] round it
MARGIN = 20  # [pixels] to the picture's edge
WHITE = 255


def path_of_frames(saved: Saved, graphics: Graphics) -> Picture:
    """Figure 6: keyframes darkest, variable frames less dark, in-betweens lightest."""
    return figure_six(saved, Look(WIDTH, TALL), graphics)


def turning_body(saved: Saved, graphics: Graphics) -> Picture:
    """Figure 7: the keyframes of a body that turns and travels, and a faint path between them."""
    return figure_six(saved, Look(WIDTH, FLAT), graphics, rate=BETWEEN_RATE)


@dataclass(frozen=True)
class Dip:
    """The deepest penetration of a motion into an object on the floor.

    time   [s]
    depth  [m]
    view   a close look at what is deep, from the side that it is on
    """

    time: float
    depth: float
    view: View

    @classmethod
    def of(cls, saved: Saved, timeline: Timeline) -> Dip:
        model = saved.figure.model
        contact = looked_at(saved, timeline)
        floors = {model.geom(int(g)).name for g in np.flatnonzero(model.geom_type == int(mujoco.mjtGeom.mjGEOM_PLANE))}
        depth = np.where([solid not in floors for solid in contact.into], contact.depth, 0.0)
        worst = int(np.argmax(depth))
        time = float(contact.time[worst])
        return cls(time, float(depth[worst]), _close(saved, pose(saved, timeline, time), contact.names[worst]))


def looked_at(saved: Saved, timeline: Timeline) -> Penetration:
    """The penetration depth along a motion."""
    first, last = float(timeline.times[0]), float(timeline.times[-1])
    time = np.linspace(first, last, round(LOOK_RATE * (last - first)) + 1)
    qpos = continuous(saved.figure, saved.figure.to_qpos(path_of(timeline).at(time)))
    return penetration(saved.figure.model, time, qpos)


def pose(saved: Saved, timeline: Timeline, time: float) -> Array:
    """(nq,) at a time [s]."""
    return saved.figure.to_qpos(path_of(timeline).at(np.array([time])))[0]


def keyframes_and_sample(saved: Saved, timeline: Timeline, dip: Dip, graphics: Graphics) -> Picture:
    """Figures 11 and 12: the keyframes, translucent, and the motion at the time of a dip, with a close look at it."""
    keys = saved.figure.to_qpos(path_of(timeline).at(np.array([key.time for key in saved.keys])))
    sample = pose(saved, timeline, dip.time)
    ghosts = [Ghost(q, shade=KEY_SHADE, opacity=KEY_OPACITY) for q in keys]
    fovy = float(saved.figure.model.vis.global_.fovy)
    view = still(middles(saved.figure, keys), WIDTH / TALL, "side", fovy=fovy, height=figure_height(saved))
    with Stage(saved.scene, WIDTH, TALL, graphics) as stage:
        whole = stage.picture(sample, view, ghosts=ghosts)
    height = round(CLOSE * TALL)
    with Stage(saved.scene, round(CLOSE_ASPECT * height), height, graphics) as stage:
        return inset(whole, stage.picture(sample, dip.view))


def _close(saved: Saved, qpos: Array, geom: str) -> View:
    """A look at one geom, from the left if it is on the figure's left, so that nothing stands before it."""
    model = saved.figure.model
    data = mujoco.MjData(model)
    data.qpos[:] = qpos
    mujoco.mj_kinematics(model, data)
    x, y, z = (float(entry) for entry in data.geom(geom).xpos)
    azimuth, _ = ANGLES["left" if y > middles(saved.figure, qpos[None])[0, 1] else "side"]
    return View((x, y, z), CLOSE_DISTANCE, azimuth, CLOSE_ELEVATION)


def inset(picture: Picture, small: Picture) -> Picture:
    """A small picture with a white border in the upper left corner of a large one."""
    framed = np.pad(small, ((BORDER, BORDER), (BORDER, BORDER), (0, 0)), constant_values=WHITE)
    out = picture.copy()
    out[MARGIN : MARGIN + framed.shape[0], MARGIN : MARGIN + framed.shape[1]] = framed
    return out
