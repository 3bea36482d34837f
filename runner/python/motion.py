"""Motion, the result of `inbetween`. It is immutable: every edit returns a new motion, which has no clip."""

from __future__ import annotations

import html
import io
import os
import warnings
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Literal

import mujoco
import numpy as np
from numpy.typing import ArrayLike
from rich.console import Console

from dynsplines.solver.array import Array
from dynsplines.solver.tolerances import ROUNDING

from .. import motion as files
from ..clip import text as clip_text
from ..clip.build import Clip
from ..clip.load import clip_from_motion
from ..edit import edits, thinning
from ..edit.thinning import MotionDifference
from ..errors import UserError
from ..measure.bounds import Violation
from ..measure.forces import Forces
from ..measure.report import tables
from ..measure.violation import violations
from ..motion import Sampled, Saved
from ..solving import measure
from ..system.mujoco_warnings import as_python_warnings
from ..system.output import check_target
from ..system.progress import Progress, silent
from ..system.quantity import positive


class Report(dict[str, Any]):
    """Measurements of a motion: nested dicts whose keys contain the units, printed as violations and a table."""

    def __str__(self) -> str:
        out = io.StringIO()
        Console(file=out, width=110, highlight=False).print(tables(self), markup=False)
        return out.getvalue()

    __repr__ = __str__

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(str(self))}</pre>"


@dataclass(frozen=True, eq=False, repr=False)
class Motion:
    """A motion of a figure over time, with its keyframes and its scene.

    Attributes:
        saved: The data that `save` writes to a motion file (.npz).
    """

    saved: Saved
    _clip: Clip | None = field(default=None)

    def __repr__(self) -> str:
        """ "<Motion run_and_step: 2.20 s, 12 keyframes, 33 variable frames, 39 DOF>" """
        frames, loop = self.saved.timeline.variable_count, ", loop" if self.is_loop else ""
        between = f"{frames} variable frames, " if frames else ""
        count = len(self.saved.keys)
        return f"<Motion {self.name}: {self.duration:.2f} s{loop}, {count} keyframes, {between}{self.model.nv} DOF>"

    @property
    def name(self) -> str:
        """The name of the motion and of output files."""
        return self.saved.name

    @property
    def start(self) -> float:
        """Start time [s], that of the first keyframe."""
        return float(self.saved.timeline.times[0])

    @property
    def end(self) -> float:
        """End time [s]."""
        return float(self.saved.timeline.times[-1])

    @property
    def duration(self) -> float:
        """Duration [s]."""
        return self.end - self.start

    @property
    def fps(self) -> float:
        """Default samples per second [1/s]."""
        return self.saved.fps

    @property
    def is_loop(self) -> bool:
        """Whether the motion is a loop."""
        return self.saved.timeline.ends == "periodic"

    @property
    def key_times(self) -> Array:
        """(K,) times of the keyframes [s]."""
        return np.array([key.time for key in self.saved.keys])

    @property
    def model(self) -> mujoco.MjModel:
        """The figure in its scene, as a compiled model."""
        return self.saved.figure.model

    @property
    def mjcf(self) -> str:
        """The figure in its scene, as MJCF text."""
        return self.saved.mjcf

    @cached_property
    def _problem(self) -> Clip:
        return clip_from_motion(self.saved) if self._clip is None else self._clip

    @property
    def clip(self) -> Clip:
        """The clip that was solved. A file does not store custom penalties: a warning lists them."""
        names = self.saved.search.get("custom penalties")
        if names and self._clip is None:
            called = " and ".join(f"'{name}'" for name in names)
            line = f"its search also had the custom penalty {called}, which files do not contain; pass it again"
            warnings.warn(f"{self.name}: {line}", stacklevel=2)
        return self._problem

    @cached_property
    def before(self) -> Motion:
        """The raw spline through the same keyframes."""
        return Motion(self.saved.before)

    def at(self, t: ArrayLike) -> Array:
        """Return configurations at given times.

        Args:
            t: One time, or (S,) times [s], from `start` to `end`.

        Returns:
            (nq,) or (S, nq) MuJoCo's qpos, with unit quaternions wxyz.

        Raises:
            UserError: For times outside the motion.

        Examples:
            >>> from dynsplines import inbetween
            >>> motion = inbetween("tumble")
            >>> round(float(motion.at(0.0)[2]), 3)  # height of the root [m]
            1.2
            >>> motion.at([0.0, 1.5, 3.0]).shape
            (3, 7)
        """
        times = self._times(t)
        return self.saved.at(times.ravel()).reshape(*times.shape, self.model.nq)

    def _times(self, t: ArrayLike) -> Array:
        """Return times of the motion as an array; raises UserError for others."""
        times = np.asarray(t, float)
        if times.ndim > 1:
            raise UserError(f"{self.name}: times are one number or a list of them, not {times.shape}")
        if times.size and not (self.start - ROUNDING <= times.min() and times.max() <= self.end + ROUNDING):
            raise UserError(f"{self.name}: the motion runs from {self.start:g} to {self.end:g} s; choose a time in it")
        return times

    def sampled(self, fps: float | None = None, *, times: ArrayLike | None = None) -> Sampled:
        """Return samples at equal time steps or given times.

        Args:
            fps: Samples per second [1/s]; default: those of the motion.
            times: (T,) times [s] from `start` to `end`, in place of `fps`.

        Returns:
            time (T,) [s], qpos (T, nq), qvel and qacc (T, nv) in MuJoCo's order, units and axes; `phase` and `bodies`.

        Raises:
            UserError: For times outside the motion, or both arguments.

        Examples:
            >>> from dynsplines import inbetween
            >>> run = inbetween("tumble").sampled(100)
            >>> run.time.shape, run.qpos.shape, run.qvel.shape
            ((301,), (301, 7), (301, 6))
            >>> run.bodies.position.shape  # of the world and the aeroplane
            (301, 2, 3)
        """
        if times is None:
            return Sampled.of(self.saved, self.fps if fps is None else positive(fps, "fps ="))
        if fps is not None:
            raise UserError("give fps or times, not both")
        time = self._times(times).ravel()
        if not time.size:
            raise UserError(f"{self.name}: times = []: give at least one")
        return Sampled.at(self.saved, time)

    @as_python_warnings()
    def forces(self, fps: float | None = None, *, times: ArrayLike | None = None) -> Forces:
        """Return joint torques and ground reactions at equal time steps or given times.

        They are those of MuJoCo's inverse dynamics. The ground reactions are estimated: pressure and friction at the
        points in contact supply as much of the required force as they can. Forces are nan where the
        support is unknown: while neither a foot stands nor a flight is known, and while a part other than feet and
        contact points touches the surroundings.

        Args:
            fps: Samples per second [1/s]; default: those of the motion.
            times: (T,) times [s] from `start` to `end`, in place of `fps`.

        Returns:
            sampled; torques (T, nv) [N m, N]; feet, each with name, has_contact (T,), force (T, 3) [N], centre (T, 3)
            [m] and moment (T, 3) [N m]; rest (T, 6), the force [N] and moment [N m] at the root that nothing supplies;
            has_known_support (T,). has_contact is False without known support, and may be True for a foot without load.

        Raises:
            UserError: For times outside the motion, or both arguments.

        Examples:
            >>> from dynsplines import Keyframe, build, inbetween
            >>> stand = inbetween(build("human", [Keyframe(0.0, others="rest"), Keyframe(0.5, others="rest")]))
            >>> forces = stand.forces(times=[0.25])
            >>> [foot.name for foot in forces.feet]
            ['left_foot', 'right_foot']
            >>> weight = 9.81 * stand.model.body_subtreemass[1]
            >>> f"{sum(foot.force[0, 2] for foot in forces.feet) / weight:.2f}"
            '1.00'
        """
        return Forces.of(self.sampled(fps, times=times))

    def report(self) -> Report:
        """Return measurements of the spline through the keyframes ("before") and of the solution ("after").

        The motion is sampled more finely than in the search. The result is cached.

        Returns:
            The measurements, under "before" and "after".

        Examples:
            >>> from dynsplines import inbetween
            >>> report = inbetween("tumble").report()
            >>> report["before"]["objective"] > report["after"]["objective"]
            True
            >>> sorted(report["after"]["terms"])
            ['acceleration.angular', 'acceleration.linear', 'collision.body', 'posture', 'unit']
        """
        return self._report

    @cached_property
    @as_python_warnings()
    def _report(self) -> Report:
        return Report(self.saved.report or measure(self._problem, self.saved, silent()).report)

    @property
    def _saved_with_report(self) -> Saved:
        """The content of its file, including the report if it has been computed."""
        return replace(self.saved, report=dict(self._report)) if "_report" in self.__dict__ else self.saved

    @property
    def violations(self) -> list[Violation]:
        """The violations, worst first; empty if there are none. The result is cached.

        Examples:
            >>> from dynsplines import Keyframe, build, inbetween
            >>> low = Keyframe(0.5, root={"position": [0, 0, 0.1]}, others="rest")
            >>> worst = inbetween(build("spinner", [Keyframe(0.0, others="rest"), low])).violations[0]
            >>> print(worst)
            keyframe 2 itself: propeller_1 is 31 mm in the floor at 0.50 s
            >>> worst.kind, worst.unit, worst.bound, worst.keyframe
            ('penetration', 'm', 0.005, 2)
        """
        return list(self._violations)

    @cached_property
    @as_python_warnings()
    def _violations(self) -> tuple[Violation, ...]:
        return violations(self._problem, self.saved)

    def difference(self, other: Motion) -> MotionDifference:
        """Compare the positions and rotations of all bodies with those in another motion of the same figure.

        Args:
            other: A motion that covers this one's interval; compared at this one's samples.

        Returns:
            The largest differences.

        Raises:
            UserError: For another figure, or a shorter motion.

        Examples:
            >>> from dynsplines import inbetween
            >>> motion = inbetween("tumble")
            >>> difference = motion.difference(motion.before)
            >>> print(f"{100 * difference.distance:.1f} cm at the {difference.where}, {difference.angle:.1f}°")
            0.9 cm at the nose, 1.4°
        """
        edits.check_alike(self.saved, other.saved)
        recorded = thinning.recorded_of(self.saved, 1.0, 1.0)
        first, last = recorded.times[[0, -1]]
        if other.start > first + ROUNDING or other.end < last - ROUNDING:
            raise UserError(
                f"'{other.name}' runs from {other.start:g} to {other.end:g} s, not all of {first:g} to {last:g}"
            )
        return MotionDifference.of(recorded, other.saved.timeline)

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
        """Render the motion as a video or a picture.

        Args:
            path: Output file: .mp4, .webm, .gif, or .png for a contact sheet; default NAME.mp4, or NAME.png for a
                still.
            only: "" for before and after side by side, or "before", "after", or "keys" (the keyframes).
            camera: "side", "left", "front", "three_quarter", "back", or a camera of the model.
            size: Width and height [pixels], at least 16.
            fps: Video frames per second [1/s]; default: the motion's.
            slow: Slow-motion factor.
            ghosts: Draw all frames into one .png: keyframes darkest, frames that the solver inserted lighter, other
                samples lightest.
            at: Render a single frame at this time [s].
            workers: Number of render processes; with more than one, a script needs `if __name__ == "__main__":`.
            progress: Print progress on stderr.

        Returns:
            The path of the file.

        Raises:
            UserError: For invalid arguments, or if the file cannot be written.
        """
        from ..picture.graphics import choose
        from ..picture.show import Look, draw

        if only not in ("", "before", "after", "keys"):
            raise UserError(f"only = '{only}': not one of before, after, keys")
        if np.shape(size) != (2,):
            raise UserError(f"size = {size}: give width and height in pixels, such as (1280, 720)")
        look = Look(*size, self.fps if fps is None else fps, only, ghosts, camera, slow, at)
        look.check(self.model, self.start, self.end)
        target = Path(path) if path is not None else Path(f"{self.name}.{'png' if ghosts or at is not None else 'mp4'}")
        draw(self.saved, look, choose(), target, workers or 1, Progress() if progress else silent())
        return target

    @as_python_warnings()
    def export(
        self,
        path: str | os.PathLike[str],
        to: str | None = None,
        *,
        fps: float | None = None,
        columns: str | Sequence[str] = (),
    ) -> Path:
        """Export the motion to the format of another program. An existing file is overwritten.

        Args:
            path: Output file.
            to: Name of a format, default by the ending of `path`.
            fps: Samples per second [1/s]; default: the motion's.
            columns: Only for tables: additional columns, "angles", "velocities", "torques", "wrench" (at the root),
                "ground" (force at each foot), several of these, or "all": those for which the motion has values.

        Returns:
            The path of the file.

        Raises:
            UserError: For an unknown format, or data that it cannot hold.

        Examples:
            >>> from dynsplines import inbetween
            >>> path = inbetween("tumble").export("tumble.csv", fps=60)
            >>> print(path.read_text().splitlines()[0])
            time,spin.x,spin.y,spin.z,spin.qw,spin.qx,spin.qy,spin.qz
        """
        from ..exchange import formats, quantities

        target = Path(path)
        groups = quantities.groups_of(columns if isinstance(columns, str) else ",".join(columns))
        return formats.export(self.saved, formats.choose(to, target).name, target, fps=fps, columns=groups)

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> Path:
        """Save the motion (.npz, for `load_motion`), or its clip (.toml).

        The motion file contains the report if it has been computed. Custom soft constraints are not stored; a
        warning lists them. An edited, thinned or imported motion has no clip; the .toml then contains its keyframes
        only. To change such a motion, let a clip follow its .npz, see the argument `recording` of `build`.

        Args:
            path: Output file.
            overwrite: Only for .toml. The scene of a clip is written to a second file in its folder. If such a file
                exists with other content, it is overwritten, or, if False, UserError is raised. The file at `path`
                is always overwritten.

        Returns:
            The path of the file.

        Raises:
            UserError: For another extension, or if the file cannot be written.

        Examples:
            >>> from dynsplines import inbetween, load
            >>> motion = inbetween("tumble")
            >>> print(motion.save("tumble.npz"), load(motion.save("tumble.toml")))
            tumble.npz <Clip tumble: 3.00 s, 7 keyframes, 5 penalties, 6 DOF>
        """
        target = Path(path)
        if names := self.saved.search.get("custom penalties"):
            warnings.warn(
                f"{target}: custom penalties are not stored: {', '.join(names)}; pass them again as custom_penalties=",
                stacklevel=2,
            )
        if target.suffix == ".toml":
            clip_text.write(replace(self.saved, name=target.stem), target, overwrite=overwrite)
        elif target.suffix == ".npz":
            check_target(target)
            files.save(self._saved_with_report, target)
        else:
            raise UserError(
                f"'{target}': a motion is saved as .npz, or as a clip, .toml; `export` writes other formats"
            )
        return target

    @as_python_warnings()
    def mirrored(self) -> Motion:
        """Return the motion mirrored in the x-z plane, with left and right swapped; the scene is unchanged.

        Joints are paired by left and right in their names, or else by position.

        Returns:
            The mirrored motion.

        Raises:
            UserError: For a figure whose joints are not in mirrored pairs.

        Examples:
            >>> from dynsplines import Keyframe, build, inbetween
            >>> left = Keyframe(0.5, root={"position": [0, 0.2, 1], "rotation": {"heading": 30}})
            >>> motion = inbetween(build("spinner", [Keyframe(0.0, others="rest"), left]))
            >>> print(f"{motion.at(0.5)[1]:.1f} m, {motion.mirrored().at(0.5)[1]:.1f} m")
            0.2 m, -0.2 m
        """
        return Motion(edits.mirror(self.saved))

    def retimed(self, speed: float | None = None, *, duration: float | None = None) -> Motion:
        """Return the motion at another speed.

        Args:
            speed: Speed factor; give this or `duration`.
            duration: New duration [s].

        Returns:
            The retimed motion.

        Raises:
            UserError: For invalid numbers, or if both or neither are given.

        Examples:
            >>> from dynsplines import inbetween
            >>> inbetween("tumble").retimed(1.5).duration, inbetween("tumble").retimed(duration=6).duration
            (2.0, 6.0)
        """
        if (speed is None) == (duration is None):
            raise UserError("give speed, such as 1.5, or duration, in seconds: one of them")
        if duration is not None and not 0 < duration < np.inf:
            raise UserError(f"duration = {duration:g}: give seconds, above 0")
        rate = speed if speed is not None else self.duration / (duration or self.duration)
        return Motion(edits.retime(self.saved, rate))

    def trimmed(self, first: float | None = None, last: float | None = None) -> Motion:
        """Return a part of the motion, unchanged within the interval.

        Args:
            first: Start [s]; default: the motion's.
            last: End [s]; default: the motion's.

        Returns:
            The part.

        Raises:
            UserError: For an interval that is empty or not within the motion.

        Examples:
            >>> from dynsplines import inbetween
            >>> inbetween("tumble").trimmed(0.5, 2.0)
            <Motion tumble: 1.50 s, 4 keyframes, 8 variable frames, 6 DOF>
        """
        begin, end = self.start if first is None else first, self.end if last is None else last
        return Motion(edits.trim(self.saved, begin, end))

    @as_python_warnings()
    def repeated(self, count: int) -> Motion:
        """Return a loop repeated without a seam.

        Args:
            count: Number of cycles of the result, 1 or more.

        Returns:
            The longer motion.

        Raises:
            UserError: For a motion that is not a loop.
        """
        return Motion(edits.repeat(self.saved, count))

    @as_python_warnings()
    def cleaned(self) -> Motion:
        """Return a cleaned recording: repaired, smoothed as much as its estimated noise requires, with planted feet.

        Returns:
            The cleaned motion. In its report and in `render`, "before" is the recording.

        Raises:
            UserError: For a motion that cannot be cleaned.

        Examples:
            >>> from dynsplines import import_motion, inbetween
            >>> recording = import_motion(inbetween("tumble").export("recording.csv"), figure="spinner")
            >>> clean = recording.cleaned()
            >>> clean.difference(recording).distance < 0.01
            True
        """
        from ..clean.command import clean_motion

        return Motion(clean_motion(self.saved, silent()))

    @as_python_warnings()
    def thinned(self, max_error: float | str = 0.02, *, max_angle: float = 5.0, solve: bool = False) -> Motion:
        """Return a motion without a clip and with fewer keyframes, within an error bound of this one.

        Args:
            max_error: Largest displacement of a body's origin, a site or the tip of a limb: metres, or text such as
                "2cm".
            max_angle: Largest rotation of a body [degrees].
            solve: Solve the keyframes, and apply the bound to the result. Otherwise, the result is the spline through
                the keyframes.

        Returns:
            The motion with fewer keyframes.

        Raises:
            UserError: For invalid bounds.

        Examples:
            >>> from dynsplines import import_motion, inbetween
            >>> recording = import_motion(inbetween("tumble").export("recording.csv"), figure="spinner")
            >>> thin = recording.thinned("2cm")
            >>> len(recording.key_times), len(thin.key_times)
            (91, 8)
        """
        bound = thinning.bound_of(max_error, max_angle, ("max_error =", "max_angle ="))
        return Motion(thinning.thin_motion(self.saved, *bound, solve=solve, progress=silent()))

    @as_python_warnings()
    def _repr_html_(self) -> str:
        """Return a player of the motion before and after, for notebooks: a page without external content."""
        from ..exchange.formats.html import page

        inside = html.escape(page(Sampled.of(self.saved)))
        style = "width: 100%; height: 480px; border: 0"
        return f'<iframe title="{html.escape(self.name)}" style="{style}" srcdoc="{inside}"></iframe>'
