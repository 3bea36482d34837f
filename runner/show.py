"""A motion as images: before | after side by side, one of them alone, the keyframes, or the paper's figure 6."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from solver.frame import Timeline
from solver.quaternion import Array

from . import layout
from .camera import plan, still
from .ghost import Ghost
from .graphics import Graphics
from .motion import Saved, sampled
from .stage import Picture, Stage

KEY_SECONDS = 0.5
STANDING = 2.05  # metres: a person with a hand raised over the head
KEY_SHADE, VARIABLE_SHADE, BETWEEN_SHADE = 0.0, 0.45, 0.75
KEY_OPACITY, VARIABLE_OPACITY, BETWEEN_OPACITY = 1.0, 0.55, 0.25


@dataclass(frozen=True)
class Look:
    """How a motion is shown.

    only    "" for before | after side by side, else "before", "after" or "keys"
    ghosts  draw the keyframes, darkest, beside the moving figure; in a still, also variable frames and in-betweens
    slow    how many times slower than life
    at      only the image nearest to this time [s]
    """

    width: int = 1280
    height: int = 720
    fps: float = 30.0
    only: str = ""
    ghosts: bool = False
    camera: str = "side"
    slow: float = 1.0
    at: float | None = None


def root_path(saved: Saved, qpos: Array) -> Array:
    """(T, 3) where the figure is: its free root, or the middle of its bodies for a fixed one."""
    tables = saved.figure.tables
    if tables.free_links.size:
        return qpos[:, tables.position_columns[:, 0]]
    return np.tile(saved.figure.model.stat.center, (len(qpos), 1))


def figure_height(saved: Saved) -> float:
    """How tall the figure is [m], for the camera's distance."""
    if saved.figure.tables.free_links.size:
        return STANDING
    return float(2.2 * saved.figure.model.stat.extent)


def image_count(saved: Saved, look: Look, *, still_keys: bool = False) -> int:
    """How many images `images` will give."""
    if look.only == "keys":
        return len(saved.keys) * (1 if still_keys else max(1, round(KEY_SECONDS * look.fps)))
    return 1 if look.at is not None else len(sampled(saved.figure, saved.raw, look.fps * look.slow).time)


def images(saved: Saved, look: Look, graphics: Graphics, *, still_keys: bool = False) -> Iterator[Picture]:
    """The images of a video; `still_keys` gives each keyframe once."""
    if look.only == "keys":
        return _keys(saved, look, graphics, 1 if still_keys else max(1, round(KEY_SECONDS * look.fps)))
    return _moving(saved, look, graphics)


def _stage(saved: Saved, look: Look, graphics: Graphics, halves: int) -> Stage:
    return Stage(saved.mjcf, look.width // halves, look.height, graphics)


def _keys(saved: Saved, look: Look, graphics: Graphics, repeat: int) -> Iterator[Picture]:
    figure = saved.figure
    qpos = figure.to_qpos(_key_states(saved, saved.raw))
    with _stage(saved, look, graphics, 1) as stage:
        views = plan(
            root_path(saved, qpos), 1.0, stage.aspect, look.camera,
            fovy=stage.fovy, height=figure_height(saved), cameras=stage.cameras,
        )  # fmt: skip
        for i, (q, view) in enumerate(zip(qpos, views, strict=True)):
            words = f"keyframe {i + 1} of {len(qpos)}, {saved.keys[i].time:.2f} s"
            image = layout.caption(stage.picture(q, view), words)
            for _ in range(repeat):
                yield image


def _moving(saved: Saved, look: Look, graphics: Graphics) -> Iterator[Picture]:
    sides = {"before": saved.raw, "after": saved.timeline}
    shown = [look.only] if look.only else ["before", "after"]
    runs = {name: sampled(saved.figure, sides[name], look.fps * look.slow) for name in shown}
    with _stage(saved, look, graphics, len(shown)) as stage:
        roots = np.stack([root_path(saved, run.qpos) for run in runs.values()])
        views = plan(
            roots, look.fps * look.slow, stage.aspect, look.camera,
            fovy=stage.fovy, height=figure_height(saved), cameras=stage.cameras,
        )  # fmt: skip
        ghosts = _key_ghosts(saved) if look.ghosts else ()
        time = next(iter(runs.values())).time
        chosen = range(len(time)) if look.at is None else [int(np.abs(time - look.at).argmin())]
        for i in chosen:
            view, halves = views[i], []
            for name, run in runs.items():
                picture = stage.picture(run.qpos[i], view, ghosts=ghosts)
                picture = layout.caption(picture, name)
                halves.append(layout.caption(picture, f"{run.time[i]:.2f} s", place="bottom right"))
            yield halves[0] if len(halves) == 1 else layout.side_by_side(*halves)


def _key_states(saved: Saved, timeline: Timeline) -> Array:
    at = np.searchsorted(timeline.times, [key.time - 1e-9 for key in saved.keys])
    return timeline.states[at]


def _key_ghosts(saved: Saved) -> tuple[Ghost, ...]:
    qpos = saved.figure.to_qpos(_key_states(saved, saved.timeline))
    return tuple(Ghost(q, shade=0.6, opacity=0.3) for q in qpos)


def figure_six(saved: Saved, look: Look, graphics: Graphics) -> Picture:
    """One still: keyframes darkest, variable frames lighter, in-betweens lightest (figure 6 of the paper)."""
    figure = saved.figure
    timeline = saved.raw if look.only == "before" else saved.timeline
    keys = {key.time for key in saved.keys}
    qpos = figure.to_qpos(timeline.states)
    own = np.array([any(abs(t - k) < 1e-9 for k in keys) for t in timeline.times])
    between = sampled(figure, timeline, 15.0).qpos
    ghosts = [Ghost(q, shade=BETWEEN_SHADE, opacity=BETWEEN_OPACITY) for q in between]
    if look.only != "keys":
        ghosts += [Ghost(q, shade=VARIABLE_SHADE, opacity=VARIABLE_OPACITY) for q in qpos[~own]]
    else:
        ghosts = []
    ghosts += [Ghost(q, shade=KEY_SHADE, opacity=KEY_OPACITY) for q in qpos[own]]
    with _stage(saved, look, graphics, 1) as stage:
        view = still(
            root_path(saved, qpos), stage.aspect, look.camera,
            fovy=stage.fovy, height=figure_height(saved), cameras=stage.cameras,
        )  # fmt: skip
        return stage.picture(None, view, ghosts=ghosts)
