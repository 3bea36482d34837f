"""Motion: what in-betweening gives. It is never changed: every edit gives a new one."""

from __future__ import annotations

import html
import io
import os
import warnings
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import mujoco
import numpy as np
from numpy.typing import ArrayLike
from rich.console import Console

from dynsplines.solver.array import Array
from dynsplines.solver.curve.spline import path_of

from .. import motion as files
from .. import work
from ..clip import file as clip_file
from ..clip import load as clips
from ..clip.build import Clip
from ..edit import edits, thinning
from ..errors import UserError
from ..measure import problems
from ..measure.problems import Flaw
from ..measure.report import tables
from ..motion import Sampled, Saved
from ..system.mujoco_warnings import as_python_warnings
from ..system.output import check_target
from ..system.progress import Progress
from ..system.quantity import length
from ..work import Solved

if TYPE_CHECKING:
    from ..exchange.formats import Writer

PLAYER_HEIGHT = 480  # pixels, in a notebook


@as_python_warnings()
def inbetween(clip: Clip | str | os.PathLike[str], *, progress: bool = False) -> Motion:
    """Smooth motion through a clip's keyframes that keeps to its soft constraints.

    clip      of `load` or `build`, or what `load` takes: the name of one that ships, a path, TOML text
    progress  print progress on stderr

    Ctrl-C (in a notebook: interrupt) stops the search and keeps the best motion so far; the keyframes are met exactly
    whenever it stops.
    """
    from .loading import load  # only here: it gives motions too

    heard = Progress() if progress else _silent()
    solved = work.solve(clip if isinstance(clip, Clip) else load(clip), heard)
    return Motion(solved.saved(heard, with_report=False), solved)


class Report(dict[str, Any]):
    """What a motion is like, measured at 1 kHz: plain numbers by name, and as text two tables to read."""

    def __str__(self) -> str:
        out = io.StringIO()
        Console(file=out, width=110, highlight=False).print(tables(self), markup=False)
        return out.getvalue()

    __repr__ = __str__

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(str(self))}</pre>"


@dataclass(frozen=True)
class Apart:
    """How far two motions are apart at most.

    distance, angle  [m] of a body's origin or a site, [degrees] of a body's rotation
    """

    distance: float
    where: str
    time: float
    angle: float
    turned: str
    turned_time: float

    def __str__(self) -> str:
        return (
            f"at most {100 * self.distance:.3g} cm at {self.time:.2f} s ({self.where}), "
            f"{self.angle:.3g}° at {self.turned_time:.2f} s ({self.turned})"
        )


@dataclass(frozen=True, eq=False, repr=False)
class Motion:
    """A motion of a figure over time, with the keyframes that it goes through and its scene.

    saved  all of it, as its file holds it
    """

    saved: Saved
    _solved: Solved | None = field(default=None)

    def __repr__(self) -> str:
        """ "<Motion run_and_step: 2.20 s, 12 keyframes, 33 variable frames, 39 DOF>" """
        frames, loop = self.saved.timeline.variable_count, ", loop" if self.is_loop else ""
        between = f"{frames} variable frames, " if frames else ""
        count = len(self.saved.keys)
        return f"<Motion {self.name}: {self.duration:.2f} s{loop}, {count} keyframes, {between}{self.model.nv} DOF>"

    @property
    def name(self) -> str:
        """What files made of it are called."""
        return self.saved.name

    @property
    def start(self) -> float:
        """When it begins [s], at the first keyframe's time."""
        return float(self.saved.timeline.times[0])

    @property
    def end(self) -> float:
        """When it ends [s]."""
        return float(self.saved.timeline.times[-1])

    @property
    def duration(self) -> float:
        """How long it lasts [s]."""
        return self.end - self.start

    @property
    def fps(self) -> float:
        """Samples a second, by default."""
        return self.saved.fps

    @property
    def is_loop(self) -> bool:
        """Whether its end continues at its start."""
        return self.saved.timeline.ends == "periodic"

    @property
    def key_times(self) -> Array:
        """(K,) the times of the keyframes [s]."""
        return np.array([key.time for key in self.saved.keys])

    @property
    def model(self) -> mujoco.MjModel:
        """The figure in its scene."""
        return self.saved.figure.model

    @property
    def mjcf(self) -> str:
        """The same as MJCF text."""
        return self.saved.mjcf

    @cached_property
    def clip(self) -> Clip:
        """The problem that it answers, to be in-betweened again; warns of soft constraints that no file holds."""
        if self._solved is not None:
            return self._solved.clip
        if names := self.saved.search.get("own penalties"):
            called = " and ".join(f"'{name}'" for name in names)
            line = f"its search also had the custom penalty {called}, which files do not contain; pass it again"
            warnings.warn(f"{self.name}: {line}", stacklevel=2)
        return clips.answered(self.saved)

    @cached_property
    def before(self) -> Motion:
        """The raw spline through the same keyframes, nothing searched: what it is compared with."""
        return self._edited(replace(self.saved, timeline=self.saved.raw))

    def at(self, t: ArrayLike) -> Array:
        """MuJoCo configurations at times t [s]: (nq,) for one time, (S, nq) for S; quaternions wxyz and unit."""
        times = np.asarray(t, float)
        if times.ndim > 1:
            raise UserError(f"{self.name}: times are one number or a list of them, not {times.shape}")
        if times.size and not (self.start - 1e-9 <= times.min() and times.max() <= self.end + 1e-9):
            raise UserError(f"{self.name}: the motion runs from {self.start:g} to {self.end:g} s; nothing is outside")
        qpos = self.saved.figure.to_qpos(path_of(self.saved.timeline).at(times.ravel()))
        return qpos.reshape(*times.shape, self.model.nq)

    def sampled(self, fps: float | None = None) -> Sampled:
        """time (T,) [s], qpos (T, nq), qvel and qacc (T, nv), `fps` a second; MuJoCo's order, units and axes."""
        if fps is not None and not 0 < fps < np.inf:
            raise UserError(f"{self.name}: {fps} samples a second; give a number above 0")
        return files.sampled(self.saved.figure, self.saved.timeline, fps or self.fps)

    def report(self) -> Report:
        """Before and after, measured between the samples that the optimiser saw; takes some seconds, the first time."""
        return self._report

    @cached_property
    @as_python_warnings()
    def _report(self) -> Report:
        data = self.saved.report
        if not data and self._solved is not None:
            data = self._solved.saved(_silent()).report
        elif not data:
            data = edits.measured(self.saved, _silent(), "not searched").report
        return Report(data)

    @property
    def _kept(self) -> Saved:
        """What its file holds: its report, if it has been measured."""
        return replace(self.saved, report=dict(self._report)) if "_report" in self.__dict__ else self.saved

    @property
    def problems(self) -> list[Flaw]:
        """What is wrong with it, worst first, a record each; empty if all is well. Looked for once, in a moment."""
        return list(self._problems)

    @cached_property
    @as_python_warnings()
    def _problems(self) -> tuple[Flaw, ...]:
        return problems.of_motion(self.saved) if self._solved is None else self._solved.problems

    def apart(self, other: Motion) -> Apart:
        """How far another motion of the same figure is from this, at this one's instants."""
        edits.check_alike(self.saved, other.saved)
        recorded = thinning.recorded_of(self.saved, 1.0, 1.0)
        first, last = recorded.times[[0, -1]]
        if other.start > first + 1e-9 or other.end < last - 1e-9:
            raise UserError(
                f"'{other.name}' runs from {other.start:g} to {other.end:g} s, not all of {first:g} to {last:g}"
            )
        far, turned = recorded.worst(other.saved.timeline)
        times = recorded.times[[far.instant, turned.instant]].tolist()
        return Apart(far.value, far.name, times[0], float(np.degrees(turned.value)), turned.name, times[1])

    @as_python_warnings()
    def render(
        self,
        path: str | os.PathLike[str] | None = None,
        *,
        only: Literal["", "before", "after", "keys"] = "",
        camera: str = "side",
        size: tuple[int, int] = (1280, 720),
        fps: float | None = None,
        slow: float = 1.0,
        ghosts: bool = False,
        at: float | None = None,
        workers: int | None = None,
        progress: bool = False,
    ) -> Path:
        """Draws it into .mp4, .webm, .gif, or .png for a contact sheet, and gives the file's path.

        path     output file; default NAME.mp4, or NAME.png for a still
        only     "" for before and after side by side, or one of them alone, or the keyframes
        camera   "side", "left", "front", "three_quarter", "back", or one of the model's own
        size     (width, height) of the whole picture [pixels]
        slow     how many times slower than life
        ghosts   in a .png: keyframes darkest, variable frames lighter, in-betweens lightest
        at       one image, at this time [s]
        workers  processes that draw; more than one need a script's main part behind
                 `if __name__ == "__main__":`
        """
        from ..picture.graphics import choose
        from ..picture.rendering import draw
        from ..picture.show import Look

        if only not in ("", "before", "after", "keys"):
            raise UserError(f"only = '{only}': not one of before, after, keys")
        look = Look(*size, fps or self.fps, only, ghosts, camera, slow, at)
        look.check(self.model, self.start, self.end)
        target = Path(path) if path is not None else Path(f"{self.name}.{'png' if ghosts or at is not None else 'mp4'}")
        draw(self.saved, look, choose(), target, workers or 1, Progress() if progress else _silent())
        return target

    @as_python_warnings()
    def export(
        self,
        path: str | os.PathLike[str],
        to: str | Writer | None = None,
        *,
        fps: float | None = None,
        columns: str | Sequence[str] = (),
        simulate: bool = False,
    ) -> Path:
        """Writes it in the format of another program, by the path's ending or by name, and gives the file's path.

        to        a format's name, or a writer of your own: anything with write(take, path)
        columns   of a table: "velocities", "torques", "wrench", "ground", several of them, or "all"
        simulate  of MJCF: a scene that collides, actuators on every joint, and the motion as their targets;
                  a path that ends in .simulate.xml implies it
        """
        from ..exchange import formats, quantities
        from ..exchange.take import Wishes

        target = Path(path)
        if to is not None and not isinstance(to, str):
            return formats.written_by(to, self.saved, target, fps=fps)
        wishes = Wishes(simulate, quantities.named(columns if isinstance(columns, str) else ",".join(columns)))
        return formats.export(self.saved, formats.chosen(to, target).name, target, fps=fps, wishes=wishes)

    def save(self, path: str | os.PathLike[str], *, exact: bool = False, overwrite: bool = False) -> Path:
        """Writes it as a motion, .npz, which `load_motion` opens, or as a clip, .toml, of its keyframes.

        A report goes into the file if there is one already; nothing is measured for it. Warns of soft constraints of
        your own, which no file holds.

        exact      the clip's [solve] leaves the spline through its keyframes as it is; else it is searched as ever
        overwrite  a scene that lies beside the clip and is another one
        """
        target = Path(path)
        if names := self.saved.search.get("own penalties"):
            warnings.warn(
                f"{target}: a file holds no code: {', '.join(names)} will have to be given again", stacklevel=2
            )
        if target.suffix == ".toml":
            clip_file.write(replace(self.saved, name=target.stem), target, exact=exact, overwrite=overwrite)
        elif target.suffix == ".npz":
            check_target(target)
            files.save(self._kept, target)
        else:
            raise UserError(
                f"'{target}': a motion is saved as .npz, or as a clip, .toml; `export` writes other formats"
            )
        return target

    @as_python_warnings()
    def mirrored(self) -> Motion:
        """Left and right exchanged, in the x-z plane; the scene stays."""
        return self._edited(edits.mirrored(self.saved))

    def retimed(self, speed: float | None = None, *, duration: float | None = None) -> Motion:
        """Played `speed` times as fast, or so that it lasts `duration` [s]."""
        if (speed is None) == (duration is None):
            raise UserError("give speed, such as 1.5, or duration, in seconds: one of them")
        if duration is not None and not 0 < duration < np.inf:
            raise UserError(f"duration = {duration:g}: give seconds, above 0")
        rate = speed if speed is not None else self.duration / (duration or self.duration)
        return self._edited(edits.retimed(self.saved, rate))

    def trimmed(self, first: float | None = None, last: float | None = None) -> Motion:
        """The part from one time to another [s]; inside it stays the same."""
        begin, end = self.start if first is None else first, self.end if last is None else last
        return self._edited(edits.trimmed(self.saved, begin, end))

    @as_python_warnings()
    def repeated(self, count: int) -> Motion:
        """A loop played so many times over, without a seam."""
        return self._edited(edits.repeated(self.saved, count))

    @as_python_warnings()
    def joined(self, other: Motion, transition: float = 0.4) -> Motion:
        """The motion followed by another one, moved to continue it, with a transition [s] between them."""
        return self._edited(edits.joined(self.saved, other.saved, transition, _silent()))

    @as_python_warnings()
    def cleaned(self, within: str | float | None = None) -> Motion:
        """A recording made physical: repaired, smoothed by its own noise, with feet that stay where they stand.

        within  how far hands, feet and pelvis may be moved, where their stances allow it: "3cm", "30mm", or metres
        """
        from ..clean.running import motion_cleaned

        bound = None if within is None else length(within, "within")
        return Motion(motion_cleaned(self.saved, bound, _silent()))

    @as_python_warnings()
    def thinned(self, max_error: float | str = 0.02, *, max_angle: float = 5.0, solve: bool = False) -> Motion:
        """The fewest keyframes found that keep it within a bound of what it is, at every instant looked at.

        max_error  of any body's origin, any site and any limb's tip: metres, or text such as "2cm"; a quarter of it for
                   hands and feet, or whatever ends a limb, while they stand still
        max_angle  of any body's rotation [degrees]
        solve      let the in-between through the keyframes keep the bound, and not only the spline
        """
        if not 0 < max_angle <= 180:
            raise UserError(f"max_angle = {max_angle:g}: give degrees, above 0 and up to 180")
        bound = length(max_error, "max_error ="), float(np.radians(max_angle))
        return self._edited(thinning.thinned(self.saved, *bound, solve=solve, progress=_silent()).motion)

    def _edited(self, saved: Saved) -> Motion:
        return Motion(replace(saved, trace=[], report={}, search={}))

    @as_python_warnings()
    def _repr_html_(self) -> str:
        """The motion playing, before and after, in a notebook: a page that needs nothing from elsewhere."""
        from ..exchange.format.html import page
        from ..exchange.take import Take

        inside = html.escape(page(Take.of(self.saved)))
        style = f"width: 100%; height: {PLAYER_HEIGHT}px; border: 0"
        return f'<iframe title="{html.escape(self.name)}" style="{style}" srcdoc="{inside}"></iframe>'


def _silent() -> Progress:
    return Progress(Console(quiet=True))
