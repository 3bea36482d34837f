"""A cache of solved clips: a clip is solved again only if its inputs have changed.

The cache is in the user's cache folder, in DYNSPLINES_CACHE=FOLDER if that is set, or disabled by DYNSPLINES_CACHE=off.
The name of a file is a hash of everything on which the search depends: keyframes and settings, the scene with all files
of its model, the text of this program, and the versions of numerical libraries.

A file contains plain arrays, which are checked before use. A damaged file, or one that does not pass through the
clip's keyframes, counts as missing. If caching fails, the clip is solved.
"""

from __future__ import annotations

import io
import json
import os
from collections.abc import Iterator, Mapping
from contextlib import suppress
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from dynsplines import solver
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.search.minimum import Stop
from dynsplines.solver.solution import Solution

from . import solving
from .clip.build import Clip
from .clip.parse import table_of
from .clip.text import tables
from .measure.exactness import keyframe_error
from .motion import Saved, check_timeline, read_arrays
from .solving import Solved
from .system.cache_folder import hash_of, place, store, version_of
from .system.progress import Progress

FORMAT = 1  # version of the file format
MOST_BYTES = 200_000_000  # [bytes] of all files together; a clip of some seconds takes 50 to 200 kB

LIBRARIES = ("mujoco", "numpy", "scipy", "nlopt")
UNMET = 1e-9  # [m, rad] rounding tolerance of keyframes
APART = ("figure", "fps")  # keys of a clip on which its solution does not depend; the scene contains the figure


def solved(clip: Clip, progress: Progress, *, no_cache: bool = False) -> Solved:
    """Return the solution of a clip, from the cache if its inputs have not changed; `no_cache` ignores the cache."""
    folder = place()
    if folder is None:
        return solving.solve(clip, progress)
    file = folder / f"{key_of(clip)}.npz"
    solution = None if no_cache else read(file, clip)
    if solution is None:
        solution = solving.solve(clip, progress)
        if solution.motion.stop is not Stop.INTERRUPTED:
            write(solution, file)
        return solution
    solving.report_notes(clip, progress)
    progress.report(
        f"solved before: {solving.course(solution.motion) or 'nothing to search'}; --no-cache solves it again"
    )
    return solution


def saved(source: Clip | Saved, progress: Progress, *, no_cache: bool = False) -> Saved:
    """Return a saved motion unchanged, or that of a clip without a report; `no_cache` as for `solved`."""
    if isinstance(source, Saved):
        return source
    return solved(source, progress, no_cache=no_cache).saved(progress, with_report=False)


def key_of(clip: Clip) -> str:
    """Return a hash of all inputs of the search, as 40 hexadecimal digits."""
    return hash_of(_parts(clip))


def _parts(clip: Clip) -> Iterator[bytes]:
    yield _program().encode()
    yield clip.scene.mjcf.encode()
    for name, data in sorted(clip.scene.assets.items()):
        yield name.encode()
        yield data
    content = tables(table_of(clip.text, clip.name)) if clip.text else {}
    content = {key: value for key, value in content.items() if key not in APART}
    yield json.dumps(content, sort_keys=True, default=str).encode()
    for key in clip.keys:
        yield np.float64(key.time).tobytes()
        yield key.state.tobytes()
        yield key.fixed.tobytes() + key.known.tobytes()
    weights = [(penalty.name, weight) for penalty, weight in clip.penalties]
    yield repr(
        (clip.figure.coordinates, clip.ends, clip.problem.travel, clip.problem.turn, clip.settings, weights)
    ).encode()
    yield b"" if clip.problem.end_slope is None else clip.problem.end_slope.tobytes()


@lru_cache(maxsize=1)
def _program() -> str:
    """Return the version of the solver: a hash of this program, and the versions of libraries."""
    parts = [str(FORMAT).encode()]
    for folder in (Path(solver.__file__).parent, Path(__file__).parent):
        for file in sorted(folder.rglob("*.py")):
            parts += [file.relative_to(folder).as_posix().encode(), file.read_bytes()]
    return " ".join([hash_of(parts), *map(version_of, ("dynamic-splines", *LIBRARIES))])


def write(result: Solved, file: Path) -> None:
    """Write a solved clip, if possible."""
    motion, stream = result.motion, io.BytesIO()
    timeline = motion.timeline
    np.savez(
        stream,
        allow_pickle=False,
        key=file.stem,
        time=timeline.times,
        state=timeline.states,
        end_slope=timeline.end_slope,
        trace=json.dumps(motion.trace),
        evaluations=motion.evaluations,
        stop=motion.stop.name,
        seconds=result.seconds or 0.0,
    )
    store(file, stream.getvalue(), MOST_BYTES)


def read(file: Path, clip: Clip) -> Solved | None:
    """Return the cached solution of a clip; None if it is missing or invalid."""
    if not file.is_file():
        return None
    try:
        solution = _restored(clip, read_arrays(file), file.stem)
    except Exception:  # a damaged file may raise any exception
        return None
    with suppress(OSError):
        os.utime(file)  # marks it as recently used
    return solution


def _restored(clip: Clip, data: Mapping[str, Any], key: str) -> Solved:
    """Return a solution. Raises an exception for data that is not a solution of the clip."""
    raw = clip.problem.raw
    timeline = _timeline(raw, data)
    seconds, evaluations = float(data["seconds"]), int(data["evaluations"])
    trace = tuple(
        (int(n), int(turn), float(value), dict(parts)) for n, turn, value, parts in json.loads(str(data["trace"]))
    )
    check_timeline(clip.figure, timeline)
    if str(data["key"]) != key or not np.isfinite(timeline.rows).all() or not np.isfinite(seconds):
        raise ValueError("not a solution of this clip")
    if not keyframe_error(clip, timeline) <= UNMET:
        raise ValueError("not through the keyframes")
    motion = Solution(clip.figure, clip.problem.objective, timeline, raw, trace, evaluations, Stop[str(data["stop"])])
    return Solved(clip, motion, seconds)


def _timeline(raw: Timeline, data: Mapping[str, Any]) -> Timeline:
    """Return the raw timeline's frames, moved, with variable frames in between."""
    times, states = data["time"], data["state"]
    at = np.searchsorted(times, raw.times)
    if times.ndim != 1 or not np.array_equal(times[at], raw.times):
        raise ValueError("a keyframe has no frame")
    fixed = np.zeros(states.shape, bool)
    fixed[at] = raw.fixed
    posed = [None] * times.size
    for index, frame in zip(at.tolist(), raw.frames, strict=True):
        posed[index] = frame.posed
    return Timeline(tuple(Frame.many(times, states, fixed, posed)), data["end_slope"], raw.ends)
