"""The command `clean`: from a recording's file to a clean one, with a report."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.problem import Improvement

from .. import motion
from ..clip.kinds import Options
from ..clip.load import clip_from_motion, figure_of, obstacles
from ..clip.parse import file_of
from ..clip.table import MapTable, SceneTable, SurroundingsTable
from ..clip.tracking.problem import rests_of, tracking_context
from ..errors import UserError, list_names
from ..exchange import formats, gaps
from ..exchange.motion_import import read_recording
from ..exchange.recording import Recording
from ..exchange.skeleton import maps
from ..measure import violation
from ..measure.measurement import Measurement
from ..measure.report import compare
from ..motion import Saved
from ..scene import file_access
from ..scene.assets import Scene
from ..system import signals
from ..system.output import check_target
from ..system.progress import Progress, silent
from .cleaning import Cleaned, clean, displacements
from .repairs import outliers, repair

SLOWER = 0.95  # [1] factor on the speed limit of joints, because soft constraints are exceeded a little
FAR = 0.05  # [m] displacement in 95 % of the time above which stances are in doubt: most for captured motion is 2.7 cm


@dataclass(frozen=True)
class Source:
    """A recording's file, and data that it lacks.

    figure, kind, fps, scale  as for `import`
    scene     a TOML file with [scene], the surroundings, and [[contact]], the stances
    map       a TOML file with the bone map
    avoids_self_collision  whether limbs must not penetrate each other
    speed     [rad/s] largest speed of joints
    """

    file: Path
    figure: str | None = None
    kind: str | None = None
    fps: float | None = None
    scale: float | None = None
    scene: Path | None = None
    map: Path | None = None
    avoids_self_collision: bool = False
    speed: float | None = None

    @property
    def options(self) -> dict[str, Options]:
        """The options of soft constraints by kind."""
        speed = None if self.speed is None else float(np.degrees(SLOWER * self.speed))
        return {
            "collision": Options.without_checks(self=self.avoids_self_collision),
            "limits": Options.without_checks(speed=speed),
        }


def run(
    source: Source,
    target: Path | None,
    *,
    overwrite: bool = False,
    progress: Progress,
) -> Path:
    """Clean a recording, write it, and report its violations; return its path.

    Raises UserError, if possible before any long computation.
    """
    target = target or _target(source)
    form = formats.by_ending(target)
    if form is not None or target.suffix != ".npz":
        form = formats.choose(None, target)
    check_target(target)
    if target.exists() and source.file.exists() and target.samefile(source.file):
        raise UserError(f"'{target}' is what is read; give another -o")
    check_target(target, overwrite=overwrite)
    saved = clean_recording(source, progress)
    if form is None:
        motion.save(saved, target)
    else:
        formats.export(saved, form.name, target, overwrite=overwrite, report=progress.report)
    if signals.code(0):
        progress.report(f"wrote {target}")
        return target
    before, after = Measurement.sides(clip_from_motion(saved), saved)
    progress.console.print(compare(before, after))
    violations = violation.by_name(violation.violations_of(after))
    for line in (f"wrote {target}", *violation.lines(violations, None if form else target)):
        progress.report(line)
    return target


def moving(file: Path, figure: str, scene: SceneTable) -> Saved:
    """Return the cleaned motion of a recording that a clip in a scene follows; raises UserError."""
    if not file.is_file():
        raise UserError(f"no file '{file}'")
    if (form := formats.by_ending(file)) is None or not form.reads:
        known = ", ".join(each.ending for each in formats.readers().values())
        raise UserError(
            f"'{file}' is neither a motion, .npz, nor a clip, .toml, nor a recording by its ending ({known}); "
            f"`dynsplines clean` or `import` makes a motion of others"
        )
    stat = file.stat()
    scene_json = scene.model_dump_json(by_alias=True, exclude_unset=True)
    return _moving(file, figure, scene_json, (stat.st_mtime_ns, stat.st_size), file_access.is_allowed())


@lru_cache(maxsize=2)
def _moving(file: Path, figure: str, scene: str, _state: tuple[int, int], _allowed: bool) -> Saved:
    """Cached while the file is unchanged: editing a clip reads it repeatedly."""
    around, progress = SurroundingsTable(scene=SceneTable.model_validate_json(scene)), silent()
    recording = _read(Source(file, figure), around, progress)
    return _clean(recording, around, progress)


def clean_recording(source: Source, progress: Progress) -> Saved:
    """Return the motion of a cleaned recording. Raises UserError."""
    around = SurroundingsTable() if source.scene is None else file_of(source.scene, SurroundingsTable)
    recording = _read(source, around, progress)
    return _clean(recording, around, progress, source)


def clean_motion(saved: Saved, progress: Progress) -> Saved:
    """Return a motion of this program, cleaned."""
    return _clean(_of_motion(saved), SurroundingsTable(), progress)


def _of_motion(saved: Saved) -> Recording:
    """Return a motion of this program at its rate."""
    samples = motion.Sampled.of(saved)
    return Recording(samples.time, samples.qpos, saved.scene, saved.fps, name=saved.name)


def _target(source: Source) -> Path:
    """Return a path in the current folder, named after the input, in its format if that can be written."""
    form = formats.by_ending(source.file)
    ending = form.ending if form is not None and form.writes else ".npz"
    return Path(f"{formats.stem(source.file)}.clean{ending}")


def _read(source: Source, around: SurroundingsTable, progress: Progress) -> Recording:
    is_specified = source.figure is not None or source.kind is not None
    if not is_specified and motion.is_motion(str(source.file)) and not formats.is_foreign(source.file):
        if around.scene.model_fields_set:
            raise UserError(f"'{source.file}' is a motion and brings its scene along; --scene is for other files")
        if source.map is not None:
            raise UserError(f"'{source.file}' is a motion: a bone map is for recordings of skeletons; leave out --map")
        return _of_motion(motion.load(source.file))
    chosen = MapTable() if source.map is None else file_of(source.map, MapTable)
    with maps.using(chosen) as applied, gaps.allow():
        recording = read_recording(
            source.file, source.kind, figure=source.figure, fps=source.fps, scale=source.scale, progress=progress,
            obstacles=obstacles(around.scene),
        )  # fmt: skip
    if source.map is not None and not applied:
        raise UserError(f"'{source.file}': it already contains joints of the figure; omit --map")
    return recording


def _clean(
    recording: Recording,
    around: SurroundingsTable,
    progress: Progress,
    source: Source | None = None,
) -> Saved:
    assert recording.scene is not None
    figure = figure_of(recording.scene, recording.name)
    repaired, known = repair(figure, recording)
    for note in repaired.notes:
        progress.report(f"note: {note}")
    context = tracking_context(figure, repaired.time, figure.to_state(repaired.qpos), recording.name)
    options = {} if source is None else source.options
    span = float(repaired.time[0]), float(repaired.time[-1])
    requested = rests_of(context, around.contact, span) if around.contact else None

    def improved(improvement: Improvement) -> None:
        progress.step("cleaning", None, f"evaluation {improvement.evaluation}, objective {improvement.value:.4g}")

    result = clean(context, options, repaired, known, requested, improved=improved)
    for line in _notes(result):
        progress.report(line)
    return _save(result, recording.name, recording.scene, recording.rate)


def _notes(result: Cleaned) -> Iterator[str]:
    """Yield the stances of every point, first those of soles, and notes on what to check."""
    yield from (f"note: {note}" for note in outliers(result.recorded))
    if not result.rests:
        yield "note: no stance was detected, so feet may slip"
    names = [point.name for point in (*result.context.points, *(rest.point for rest in result.rests))]
    for name in dict.fromkeys(names):
        spans = [f"{rest.first:.2f}-{rest.last:.2f}" for rest in result.rests if rest.point.name == name]
        if spans:
            yield f"{name} stands {list_names(spans, 6)} s"
    longest = {rest.point.name: rest for rest in sorted(result.raised, key=lambda rest: rest.last - rest.first)}
    for name, rest in longest.items():
        yield (
            f"note: {name} rests above the ground at {rest.first:.2f}-{rest.last:.2f} s, which is not a stance; if it "
            "is one, give the surface or the stances by --scene"
        )
    times, displaced = displacements(result)
    name, distance = max(displaced.items(), key=lambda item: float(item[1].max()))
    line = f"{name} is up to {1000 * distance.max():.0f} mm off the recording at {times[distance.argmax()]:.2f} s"
    is_far = max(np.percentile(each, 95) for each in displaced.values()) > FAR
    yield f"note: {line}; if a stance above is wrong, give the stances by --scene" if is_far else line


def _save(result: Cleaned, name: str, scene: Scene, fps: float) -> Saved:
    """Return the motion with every frame as a keyframe; raw is the recording."""
    figure, timeline = result.figure, result.solution.timeline
    everything = np.ones(timeline.states.shape, bool)
    exact = Timeline(tuple(Frame.many(timeline.times, timeline.states, everything)), timeline.end_slope, timeline.ends)
    times = np.union1d(result.before.spline.times, timeline.times)
    recorded = figure.to_qpos(result.before.at(times))
    raw = raw_timeline(figure, Frame.many(times, recorded, np.ones(recorded.shape, bool)))
    keys = tuple(Frame.many(timeline.times, figure.to_qpos(timeline.states), everything))
    return Saved(name, "", scene, figure, fps, keys, exact, raw, [], {})
