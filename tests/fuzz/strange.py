"""Every kind of file that strangers send: one that is good, what of it a seed makes, and how the program reads it.

A reading ends well or in a UserError. Whatever else it ends in is a mistake.
"""

import io
import pickle
import re
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache, partial
from pathlib import Path
from typing import Any
from zlib import crc32

import motions
import mujoco
import numpy as np
import problems
from fuzz.mangle import Rng, mangled_arrays, mangled_bytes, mangled_text, mangled_tree
from processes import quiet
from rekeyed import with_keys
from texts import read_data

from dynsplines import motion, recordings, solving
from dynsplines.clip import load as clips
from dynsplines.clip.parse import references, table_of
from dynsplines.clip.starter import starter
from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.exchange.motion_import import import_recording
from dynsplines.measure.report import keyframe_error
from dynsplines.measure.violation import violations
from dynsplines.motion import Saved
from dynsplines.scene.compose import figure_spec

READ, REFUSED = "read", "refused"
Make = Callable[[Rng], bytes]
Read = Callable[[Path], object]

POSING = re.compile(rb"sites|bodies|hold|contact")
POSED_OF, WHOLE_OF = 300, 5  # one of so many is read to the end
EXACT = 1e-12  # of the largest number of a keyframe
FEW = 2  # evaluations, frames and samples of a search
MOST_SECONDS = 30.0  # of a clip that is searched or written out


@dataclass(frozen=True)
class Kind:
    """What a file is called, a good one, what a seed makes, and who reads it; a folder of its own has `beside` in it.

    long, short  how many are tried by command and as part of the tests
    """

    name: str
    good: Callable[[], bytes]
    make: Make
    read: Read
    long: int
    short: int
    beside: tuple[tuple[str, str], ...] = ()


MODEL, CLIP = read_data("rich.xml"), read_data("every_table.toml")
RATES = {"human": 50.0}  # [1/s] of what is written, of three frames
FIGURES = (
    ("rich.xml", MODEL), ("tiny.xml", problems.FIGURE), ("hinge.xml", problems.HINGE.format(keys="")),
    ("robot.xml", motions.ROBOT),
)  # fmt: skip


@cache
def _saved(figure: str) -> Saved:
    """A motion of a few frames, good to be written in any format."""
    if figure == "tiny":
        clip = recordings.from_text(problems.CLIP, name="tiny", spec=mujoco.MjSpec.from_string(problems.FIGURE))
        return solving.measure(clip, solving.raw_spline(clip), quiet())
    saved = motions.motion_of("human") if figure == "human" else motions.through(figure, *_robot_keys())
    clip = clips.of_motion(saved)
    return solving.raw_spline(with_keys(clip, list(clip.keys)[:3]))


def _robot_keys() -> tuple[Any, Any]:
    qpos = np.zeros((3, 12))
    qpos[:, 2], qpos[:, 3], qpos[:, 0] = 0.8, 1.0, [0, 0.1, 0.3]
    qpos[:, 7:] = np.linspace(-0.3, 0.3, 15).reshape(3, 5)
    return np.array([0.0, 0.3, 0.6]), qpos


def _bytes_of(write: Callable[[Path], object], ending: str) -> bytes:
    """The content of a file that is written."""
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / f"a{ending}"
        write(target)
        return target.read_bytes()


@cache
def _exported(kind: str, figure: str) -> bytes:
    """A good file of a format."""
    write = partial(formats.export, _saved(figure), kind, fps=RATES.get(figure, 10.0))
    return _bytes_of(lambda target: write(target=target), formats.writer(kind).ending)


@cache
def _motion_file() -> bytes:
    return _bytes_of(partial(motion.save, _saved("tiny")), ".npz")


@cache
def _arrays(data: bytes) -> dict[str, Any]:
    with np.load(io.BytesIO(data)) as found:
        return {name: found[name] for name in found.files}


def _of_text(source: Callable[[], bytes], rng: Rng) -> bytes:
    return mangled_text(source().decode(), rng)


def _of_arrays(source: Callable[[], bytes], rng: Rng) -> bytes:
    return mangled_arrays(_arrays(source()), rng)


def _of_pickle(source: Callable[[], bytes], rng: Rng) -> bytes:
    if rng.random() < 0.5:
        return mangled_bytes(source(), rng)
    try:
        found = mangled_tree(pickle.loads(source()), rng)
        return pickle.dumps(found, protocol=int(rng.integers(6)))
    except (RecursionError, OverflowError):
        return b"(" * 100_000


def _amass() -> bytes:
    stream = io.BytesIO()
    walk = np.array([[0, 0, 1.0], [0.01, -0.02, 1.01], [0.02, -0.04, 1.03]])
    poses = 0.3 * np.sin(np.arange(3.0 * 156)).reshape(3, 156)
    np.savez(stream, poses=poses, trans=walk, mocap_framerate=np.array(120.0), gender=np.array("male"))
    return stream.getvalue()


# how they are read


def _read_clip(path: Path) -> None:
    """Its tables; of some all that they mean, of few that put points in places, for poses take long."""
    data = path.read_bytes()
    if crc32(data) % (POSED_OF if POSING.search(data) else WHOLE_OF):
        text = data.decode("utf-8", "replace")
        references(text)
        table_of(text, path.name)
        return
    recordings.load(str(path))


def _solve(path: Path) -> None:
    """A search of a moment: finite, through the keyframes."""
    clip = recordings.load(str(path))
    if clip.keys[-1].time - clip.keys[0].time > MOST_SECONDS:
        return
    own = clip.settings
    few = {"max_evaluations": min(own.max_evaluations, FEW), "frames": min(own.frames or 0, FEW)}
    clip = clip.with_problem(settings=replace(own, variable=min(own.variable or 0, 1), **few))
    timeline = solving.solve(clip, quiet()).timeline
    assert np.isfinite(timeline.rows).all(), "a motion that is not finite"
    largest = max(1.0, *(float(np.abs(key.state[key.fixed]).max(initial=0.0)) for key in clip.keys))
    error = keyframe_error(clip, timeline)
    assert error <= EXACT * largest, f"a keyframe is missed by {error:g}"


def _read_motion(path: Path) -> None:
    saved = motion.load(path)
    assert isinstance(violations(clips.clip_from_motion(saved), saved), tuple)
    if saved.timeline.times[-1] - saved.timeline.times[0] <= MOST_SECONDS:
        formats.export(saved, "csv", path.with_name("out.csv"), fps=10.0)


def _read_mjcf(path: Path) -> None:
    """As the figure of a new clip."""
    path.with_name("new.toml").write_text(starter(str(path), path.with_name("new.toml")), encoding="utf-8")
    recordings.load(str(path.with_name("new.toml")))


def _import(kind: str, figure: str | None, path: Path) -> object:
    """The recording in it; of some the whole motion, too, which takes ten times as long."""
    if crc32(path.read_bytes()) % WHOLE_OF:
        model = None if figure is None else _model(figure)
        return formats.recording(path, kind, model=model, fps=30.0 if kind == "mjlab-csv" else None)
    return import_recording(path, kind, figure=figure, fps=30.0 if kind == "mjlab-csv" else None, progress=quiet())


@cache
def _model(figure: str) -> mujoco.MjModel:
    return figure_spec(figure).compile()


def _kind_of(name: str, figure: str | None, make: Callable[[Callable[[], bytes], Rng], bytes], long: int) -> Kind:
    """A format of others, of a motion of the robot or the person as we write it."""
    source = partial(_exported, name, figure or "tiny")
    ending = formats.readers()[name].ending
    return Kind(f"{name}{ending}", source, partial(make, source), partial(_import, name, figure), long, 3, FIGURES)


def _clip_source(rng: Rng) -> bytes:
    short = problems.changed("evaluations = 8", "evaluations = 2")
    return mangled_text((short, short, CLIP)[int(rng.integers(3))], rng)


def _mjcf_source(rng: Rng) -> bytes:
    text = (
        MODEL,
        problems.HINGE.format(keys='<keyframe><key qpos="0 0"/><key time="1" qpos="1 1"/></keyframe>'),
    )
    return mangled_text(text[int(rng.integers(len(text)))], rng)


KINDS = {
    each.name: each
    for each in (
        Kind("clip.toml", CLIP.encode, _clip_source, _read_clip, 100_000, 12, FIGURES),
        Kind("solve.toml", CLIP.encode, _clip_source, _solve, 6_000, 4, FIGURES),
        Kind("motion.npz", _motion_file, partial(_of_arrays, _motion_file), _read_motion, 4_000, 4),
        Kind("model.xml", MODEL.encode, _mjcf_source, _read_mjcf, 3_000, 4),
        _kind_of("csv", "robot.xml", _of_text, 2_000),
        _kind_of("npz", None, _of_arrays, 2_000),
        _kind_of("mjlab", "robot.xml", _of_arrays, 2_000),
        _kind_of("mjlab-csv", "robot.xml", _of_text, 1_500),
        _kind_of("locomujoco", "robot.xml", _of_arrays, 2_000),
        _kind_of("gmr", "robot.xml", _of_pickle, 3_000),
        _kind_of("mimickit", "human", _of_pickle, 2_500),
        _kind_of("bvh", "human", _of_text, 2_000),
        Kind(
            "amass.amass.npz", _amass, partial(_of_arrays, _amass), partial(_import, "amass", "human"), 1_500, 6
        ),
    )
}  # fmt: skip


def seeded(kind: str, seed: int) -> Rng:
    return np.random.default_rng([list(KINDS).index(kind), seed])


def attempt(kind: Kind, seed: int, folder: Path) -> str:
    """What becomes of one file: read, refused, or the mistake."""
    path = folder / kind.name
    path.write_bytes(kind.make(seeded(kind.name, seed)))
    try:
        kind.read(path)
    except UserError as error:
        return REFUSED if str(error) and "\n" not in str(error) else f"no line: {str(error)!r:.200}"
    return READ
