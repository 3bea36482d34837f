"""A motion as images: before and after side by side, one of them, the keyframes, or the paper's figure 6."""

from __future__ import annotations

import contextlib
from collections.abc import Generator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from numbers import Integral
from pathlib import Path
from typing import Any, Literal

import mujoco
import numpy as np
from PIL import Image, ImageDraw, ImageFont

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.tolerances import ROUNDING

from ..errors import UserError, unknown
from ..motion import Sampled, Saved
from ..scene.assets import Scene
from ..scene.framing import height, middles, spread
from ..system.progress import Progress
from ..system.quantity import positive
from ..system.workers import MOST_WORKERS, cores, in_order
from . import film
from .camera import ANGLES, View, plan, still
from .film import Picture
from .graphics import Graphics
from .stage import Ghost, Stage

KEY_SECONDS = 0.5  # [s] duration of a keyframe in a video of keyframes
PIXELS_OF_A_PROCESS = 4_000_000  # minimum number of pixels per process; drawing them takes twice its starting time
SMALLEST = 16  # [pixels] minimum width and height
MAX_FRAMES = 100_000  # maximum number of video frames, an hour at 30 frames per second
PAPER, INK = (250, 251, 252), (24, 30, 38)  # red, green, blue of captions


@dataclass(frozen=True)
class Look:
    """The appearance of a rendered motion.

    Attributes:
        width: Of a video frame [pixels].
        height: Of a video frame [pixels].
        fps: Video frames per second [1/s].
        only: "" for before and after side by side, else "before", "after" or "keys".
        ghosts: Whether to draw the keyframes besides the moving figure; in a still, also variable frames and
            in-betweens.
        camera: The view or camera, see `camera.plan`.
        slow: Slow-motion factor.
        at: The time of a single frame [s].
    """

    width: int = 1280
    height: int = 720
    fps: float = 30.0
    only: str = ""
    ghosts: bool = False
    camera: str = "side"
    slow: float = 1.0
    at: float | None = None

    def check(self, model: mujoco.MjModel, first: float, last: float, *, flags: str = "") -> None:
        """Raise UserError for a size, rate, camera, time or number of frames that is invalid for a motion from `first`
        to `last` [s].

        `flags` is the prefix of names in messages.
        """
        if not all(isinstance(side, Integral) and side >= SMALLEST for side in (self.width, self.height)):
            raise UserError(f"{flags}size {self.width}x{self.height}: give whole numbers of pixels from {SMALLEST} on")
        for name, value in (("fps", self.fps), ("slow", self.slow)):
            positive(value, f"{flags}{name}")
        cameras = [*ANGLES, *(name for i in range(model.ncam) if (name := model.camera(i).name))]
        if self.camera not in cameras:
            raise UserError(f"{flags}camera: {unknown('camera', self.camera, cameras)}")
        if self.at is not None and not first <= self.at <= last:
            raise UserError(
                f"{flags}at {self.at:g}: the motion runs from {first:g} to {last:g} s; nothing is at {self.at:g}"
            )
        count = (last - first) * self.fps * self.slow
        if count > MAX_FRAMES:
            raise UserError(f"{count:.0f} images; over {MAX_FRAMES}: lower {flags}fps or {flags}slow")


@dataclass(frozen=True)
class Shot:
    """One image to be drawn: pictures side by side, seen by one camera, in a number of video frames.

    Attributes:
        poses: The configuration (nq,) and the title of every picture.
        corner: The text in the lower corner.
    """

    view: View
    poses: tuple[tuple[Array, str], ...]
    corner: str = ""
    ghosts: tuple[Ghost, ...] = ()
    frames: int = 1


def draw(
    saved: Saved, look: Look, graphics: Graphics, target: Path, max_workers: int | None, progress: Progress
) -> None:
    """Write .mp4, .webm, .gif or .png by up to `max_workers` processes; None: one, or without OpenGL one per core.

    Raises UserError if the file cannot be written.
    """
    still = target.suffix.lower() == ".png"
    workers = max_workers or (min(cores(), MOST_WORKERS) if graphics.kind == "software" else 1)
    try:
        if look.ghosts and still:
            film.write(target, [figure_six(saved, look, graphics)], look.fps)
            return
        shots = shots_of(saved, look)
        if still:
            most = len(shots) if look.only == "keys" else film.SHEET_PICTURES
            shots = [replace(shots[i], frames=1) for i in spread(len(shots), most)]
        with contextlib.closing(images(saved, look, graphics, shots, workers)) as pictures:
            film.write(target, progress.over(pictures, "rendering", sum(shot.frames for shot in shots)), look.fps)
    except ValueError as error:
        raise UserError(str(error)) from None
    except OSError as error:
        raise UserError(f"cannot write '{target}': {error.strerror or error}") from None


def figure_height(saved: Saved) -> float:
    """Return the height of the figure for the camera's distance [m]."""
    return height(saved.figure, saved.figure.to_qpos(np.concatenate([saved.raw.states, saved.timeline.states])))


def images(
    saved: Saved, look: Look, graphics: Graphics, shots: Sequence[Shot] | None = None, workers: int = 1
) -> Generator[Picture, None, None]:
    """Yield the frames of a video, or those of some of its shots, by up to `workers` processes."""
    shots = shots_of(saved, look) if shots is None else shots
    processes = max(1, min(workers, len(shots), len(shots) * look.width * look.height // PIXELS_OF_A_PROCESS))
    stage = partial(_stage, saved.scene, look, graphics, len(shots[0].poses))
    for shot, image in zip(shots, in_order(stage, _draw, shots, processes), strict=True):
        for _ in range(shot.frames):
            yield image


def shots_of(saved: Saved, look: Look) -> list[Shot]:
    """Return the images of a video."""
    return _key_shots(saved, look) if look.only == "keys" else _moving_shots(saved, look)


def _stage(scene: Scene, look: Look, graphics: Graphics, panes: int) -> Stage:
    return Stage(scene, look.width // panes, look.height, graphics)


def _draw(stage: Stage, shot: Shot) -> Picture:
    halves = []
    for qpos, title in shot.poses:
        picture = caption(stage.picture(qpos, shot.view, ghosts=shot.ghosts), title)
        halves.append(caption(picture, shot.corner, place="bottom right"))
    return halves[0] if len(halves) == 1 else side_by_side(*halves)


def side_by_side(left: Picture, right: Picture) -> Picture:
    """Return two pictures of equal height as one, (H, Wl + Wr, 3), with a fine line between them."""
    both = np.concatenate([left, right], axis=1)
    seam = left.shape[1]
    both[:, seam - 1 : seam + 1] = PAPER
    return both


def caption(image: Picture, text: str, *, place: Literal["top", "bottom right"] = "top") -> Picture:
    """Return the picture with pale-edged words, such as "before" or "0.80 s".

    The height of the letters is 1/30 of the picture's, and less for long text.
    """
    if not text:
        return image
    height, width = image.shape[:2]
    margin, letters = height / 40, max(9, height / 30)
    high = min(height, round(2 * margin + 2 * letters))  # the rows of the picture that are drawn on
    rows, out = slice(high) if place == "top" else slice(height - high, height), image.copy()
    strip = Image.fromarray(out[rows])
    draw = ImageDraw.Draw(strip)
    long = draw.textlength(text, ImageFont.load_default(letters))
    letters = max(1, letters * min(1, (width - 4 * margin) / max(long, 1)))
    middle, corner = (width / 2, 2 * margin), (width - margin, high - margin)
    at, anchor = (middle, "mm") if place == "top" else (corner, "rd")
    font = ImageFont.load_default(letters)
    draw.text(at, text, INK, font, anchor, stroke_width=round(letters / 6), stroke_fill=PAPER)
    out[rows] = np.asarray(strip)
    return out


def _key_shots(saved: Saved, look: Look) -> list[Shot]:
    qpos = saved.figure.to_qpos(_key_states(saved, saved.raw))
    views, frames = _plan(saved, look, middles(saved.figure, qpos), 1.0, 1), max(1, round(KEY_SECONDS * look.fps))
    return [
        Shot(view, ((q, f"keyframe {i} of {len(qpos)}, {key.time:.2f} s"),), frames=frames)
        for i, (q, view, key) in enumerate(zip(qpos, views, saved.keys, strict=True), 1)
    ]


def _moving_shots(saved: Saved, look: Look) -> list[Shot]:
    sides = {"before": saved.before, "after": saved}
    shown = [look.only] if look.only else ["before", "after"]
    titles = {name: name if len(shown) > 1 else "" for name in shown}
    runs = {name: Sampled.of(sides[name], look.fps * look.slow) for name in shown}
    roots = np.stack([middles(saved.figure, run.qpos) for run in runs.values()])
    views = _plan(saved, look, roots, look.fps * look.slow, len(shown))
    ghosts = _key_ghosts(saved) if look.ghosts else ()
    time = next(iter(runs.values())).time
    chosen = range(len(time)) if look.at is None else [int(np.abs(time - look.at).argmin())]
    return [
        Shot(
            views[i],
            tuple((runs[name].qpos[i], title) for name, title in titles.items()),
            f"{time[i]:.2f} s",
            ghosts,
        )
        for i in chosen
    ]


def _plan(saved: Saved, look: Look, roots: Array, fps: float, panes: int) -> tuple[View, ...]:
    return plan(roots, fps, look.width // panes / look.height, look.camera, **_lens(saved))


def _lens(saved: Saved) -> dict[str, Any]:
    """Return the arguments of a camera's plan that depend on the model."""
    model = saved.figure.model
    return {
        "fovy": float(model.vis.global_.fovy),
        "height": figure_height(saved),
        "cameras": [model.camera(i).name for i in range(model.ncam)],
    }


def _key_states(saved: Saved, timeline: Timeline) -> Array:
    at = np.searchsorted(timeline.times, [key.time - ROUNDING for key in saved.keys])
    return timeline.states[at]


def _key_ghosts(saved: Saved) -> tuple[Ghost, ...]:
    qpos = saved.figure.to_qpos(_key_states(saved, saved.timeline))
    return tuple(Ghost(q, shade=0.6, opacity=0.3) for q in qpos)


def figure_six(saved: Saved, look: Look, graphics: Graphics, *, rate: float = 15.0) -> Picture:
    """Return one still as figure 6 of the paper: keyframes darkest, then variable frames, then in-betweens (`rate`
    [1/s])."""
    figure = saved.figure
    shown = saved.before if look.only == "before" else saved
    keys = {key.time for key in saved.keys}
    qpos = figure.to_qpos(shown.timeline.states)
    is_key = np.array([any(abs(t - k) < ROUNDING for k in keys) for t in shown.timeline.times])
    between = Sampled.of(shown, rate).qpos
    ghosts = [Ghost(q, shade=0.75, opacity=0.25) for q in between]
    ghosts += [Ghost(q, shade=0.45, opacity=0.55) for q in qpos[~is_key]]
    ghosts = [*(ghosts if look.only != "keys" else ()), *map(Ghost, qpos[is_key])]
    view = still(middles(saved.figure, qpos), look.width / look.height, look.camera, **_lens(saved))
    with _stage(saved.scene, look, graphics, 1) as stage:
        return stage.picture(None, view, ghosts=ghosts)
