"""The formats of other programs, one per module; `export` writes a motion in one of them, `recording` reads one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import Any

import mujoco

from ...errors import GIVE_FORMAT, UserError, unknown
from ...motion import Sampled, Saved
from ...system import size_limit
from ...system.output import Replacement, check_target
from ...system.quantity import positive
from .. import layouts
from ..array_reader import names_in
from ..recording import Recording, median_step

OF_MOTIONS = {"format_version", "frame_state"}  # names of arrays that only this program's motions have
CONVERTIBLE = (".glb", ".gltf", ".vrm", ".fbx", ".usd", ".usda", ".usdc")  # animations that Blender converts to BVH


@dataclass(frozen=True)
class Format:
    """A file format: name, extension, one-line description, and the module that implements it.

    The module has `write(sampled, path)` if the format can be written, which may return notes for the user, and
    `read(path, model, fps)`, which returns a Recording, if it can be read; `model` is None without a figure from the
    user. Both raise UserError. An optional function `recognises(path)` decides between formats that share an extension.

    containers  extensions of other files with the same content, only read
    options     what else the format takes: "columns", groups of columns that the writer adds; "scale", the unit of
                length [m] of the reader; "assets", files of the figure in its folder
    """

    name: str
    ending: str
    description: str
    module: str
    writes: bool = True
    reads: bool = False
    containers: tuple[str, ...] = ()
    options: tuple[str, ...] = ()

    @property
    def plain_ending(self) -> str:
        """The last part of the extension: .npz for .mjlab.npz."""
        return "." + self.ending.rpartition(".")[2]

    @property
    def read_endings(self) -> tuple[str, ...]:
        return self.plain_ending, *self.containers

    def check_name(self, target: Path) -> None:
        """Raise UserError unless a file has the extension, or the last part of it without that of another format."""
        other = by_ending(target)
        is_plain = target.name.lower().endswith(self.plain_ending)
        if other is not self and not (is_plain and (other is None or other.ending == self.plain_ending)):
            endings = dict.fromkeys((self.ending, self.plain_ending))
            raise UserError(f"'{target}': the name of a file of the format {self.name} ends in {' or '.join(endings)}")


FORMATS = (
    Format("csv", ".csv", "table: time and qpos, a column per joint coordinate", "csv_table", reads=True,
           containers=(".tsv", ".txt"), options=("columns",)),
    Format("npz", ".qpos.npz", "plain arrays: time, qpos, qvel, qacc, names, figure", "arrays", reads=True),
    Format("mjcf", ".keys.xml", "MJCF of figure and scene, a <key> per sample", "mjcf_keys",
           options=("assets",)),
    Format("simulate", ".simulate.xml", "the same with actuators that follow the motion, for mj_step", "simulate",
           options=("assets",)),
    Format("mjlab", ".mjlab.npz", "mjlab, BeyondMimic: hinge angles and body poses", "mjlab", reads=True),
    Format("mjlab-csv", ".mjlab.csv", "input of mjlab, BeyondMimic: root pose (xyzw) and hinge angles, without names",
           "mjlab_csv", reads=True),
    Format("locomujoco", ".loco.npz", "LocoMuJoCo: trajectory", "locomujoco", reads=True),
    Format("gmr", ".gmr.pkl", "GMR: root pose (xyzw), hinge angles, body positions", "gmr", reads=True,
           containers=(".pickle",)),
    Format("mimickit", ".mimickit.pkl", "MimicKit: rotation vectors of root and ball joints", "mimickit", reads=True),
    Format("amass", ".amass.npz", "AMASS: motion capture of an SMPL body", "amass", writes=False, reads=True),
    Format("bvh", ".bvh", "skeleton and joint angles, y up, in centimetres", "bvh", reads=True, options=("scale",)),
    Format("gltf", ".glb", "meshes and an animation, for Blender, game engines and the web", "gltf"),
    Format("html", ".html", "page that plays the motion before and after solving, in any browser", "html"),
)  # fmt: skip


def writers() -> dict[str, Format]:
    """Return the formats for export, by name."""
    return {form.name: form for form in FORMATS if form.writes}


def readers() -> dict[str, Format]:
    """Return the formats for import, by name."""
    return {form.name: form for form in FORMATS if form.reads}


def stem(source: Path) -> str:
    """Return a file's name without the complete extension of its format: 'run' for run.loco.npz."""
    endings = (ending for form in FORMATS for ending in (form.ending, *form.containers))
    fitting = [len(ending) for ending in endings if source.name.lower().endswith(ending) and source.name != ending]
    return source.name[: -max(fitting)] if fitting else source.stem


def writer(name: str) -> Format:
    """Return the format for export of this name; raises UserError with a list of the formats."""
    available = writers()
    if name not in available and name in readers():
        raise UserError(f"the format '{name}' is read only; written are: {', '.join(available)}")
    if name not in available:
        raise UserError(unknown("format", name, available))
    return available[name]


def choose(name: str | None, target: Path | None, columns: Sequence[str] = ()) -> Format:
    """Return the format for export by its name or a file's extension.

    Raises UserError for an unknown format, a name that contradicts the extension, and columns for another format than
    csv.
    """
    available = ", ".join(writers())
    if name is not None:
        form = writer(name)
    elif target is None:
        raise UserError(f"name the format, --to, or a file with its ending, -o; formats: {available}")
    elif (by_name := by_ending(target)) is None:
        raise UserError(
            f"'{target}': its ending is of no known format; give --to, or to= in Python, one of: {available}"
        )
    else:
        form = writer(by_name.name)
    if target is not None:
        form.check_name(target)
    if columns and "columns" not in form.options:
        raise UserError(f"the format '{form.name}' cannot hold columns of forces or velocities; csv can")
    return form


def by_ending(path: Path) -> Format | None:
    """Return the format of a complete extension such as .loco.npz; None for plain .npz, which is a motion."""
    fitting = [form for form in FORMATS if path.name.lower().endswith(form.ending)]
    return max(fitting, key=lambda form: len(form.ending), default=None)


def is_foreign(path: Path) -> bool:
    """Return whether an .npz file is of another program, by its complete extension or its arrays."""
    if by_ending(path) is not None:
        return True
    if not path.is_file() or OF_MOTIONS.intersection(names_in(path)):
        return False
    return any(_recognises(form, path) for form in readers().values() if path.name.lower().endswith(form.read_endings))


def target_of(name: str, form: Format) -> Path:
    """Return the default export path of a motion: in the current folder, whatever characters its name contains."""
    plain = Path(name.replace("\\", "/")).name or "motion"
    return Path(f"{plain}{form.ending}")


def export(
    saved: Saved,
    kind: str,
    target: Path | None = None,
    *,
    fps: float | None = None,
    columns: Sequence[str] = (),
    overwrite: bool = True,
    report: Callable[[str], None] | None = None,
) -> Path:
    """Write a motion in another format, atomically; the default path is its name with the format's extension.

    columns    groups of further columns of a table
    overwrite  replace existing files, the main one and those that an MJCF refers to, unless their content is identical
    report     receives lines for the user: further files written, and data that the format cannot represent

    Raises UserError for an unknown format, the extension of another one, and a motion that the format cannot represent.
    """
    form = choose(kind, target, columns)
    target = target or target_of(saved.name, form)
    check_target(target, overwrite=overwrite)
    sampled = Sampled.of(saved, None if fps is None else positive(fps, "fps ="))
    meshes = saved.scene.assets if "assets" in form.options else {}
    others = {target.parent / name: content for name, content in meshes.items()}
    for other, content in others.items():
        if other == target:
            raise UserError(f"'{target}' is the name of a file of the figure, too; give another -o")
        if not (other.is_file() and other.read_bytes() == content):
            check_target(other, overwrite=overwrite)
    with Replacement(target) as temporary:
        notes = list(_module(form).write(sampled, temporary, *([columns] if columns else [])) or ())
    for other, content in others.items():
        with Replacement(other) as temporary:
            temporary.write_bytes(content)
    if others:
        more = f" and {len(others) - 1} more files of the figure" if len(others) > 1 else ""
        notes.append(f"wrote {next(iter(others))}{more}")
    if report is not None:
        for note in notes:
            report(note)
    return target


def recording(
    source: Path,
    kind: str | None = None,
    *,
    model: mujoco.MjModel | None = None,
    fps: float | None = None,
    scale: float | None = None,
) -> Recording:
    """Read a file of another program, in the format `kind` or that of its extension.

    model  the figure of the motion; fps [1/s] for files without a rate; scale [m] for files without a unit of length
    """
    available = readers()
    if kind is not None and kind not in available:
        raise UserError(_write_only(kind) if kind in writers() else unknown("format", kind, available))
    form = available[kind] if kind is not None else _recognise(source)
    size_limit.check_file(source)
    if scale is not None and "scale" not in form.options:
        raise UserError(f"{source}: lengths of the format '{form.name}' are metres; --scale does not apply")
    unit = {} if scale is None else {"scale": scale}
    result = _module(form).read(source, model, fps, **unit)
    step = median_step(result.time)
    if fps is not None and step and round(1 / step) != round(fps):
        raise UserError(f"{source}: it has its own times, {1 / step:.4g} samples per second; --fps does not apply")
    if model is not None:
        layouts.check_radians(model, result.qpos, source)
    tilt = layouts.doubtful_tilt(model, result, form.name)
    if tilt is None:
        return result
    if kind is None and by_ending(source) is None:
        raise UserError(f"{source}: {tilt}; convert the file, or give --from {form.name} if that is right")
    return replace(result, notes=(*result.notes, f"{tilt}; convert the file unless that is right"))


def _write_only(name: str) -> str:
    return f"the format '{name}' is only written; read are: {', '.join(readers())}"


def _recognise(source: Path) -> Format:
    """Return the format of a file by its complete extension, or by its content where several share an extension.

    Raises UserError for a file that none or several recognise, and for tables and arrays without names.
    """
    name, available = source.name.lower(), readers().values()
    if name.endswith(".npy"):
        raise UserError(f"'{source}': .npy is not read; save qpos and time in an .npz, numpy.savez(FILE, qpos=, time=)")
    if name.endswith(CONVERTIBLE):
        raise UserError(f"'{source}': {source.suffix.lower()} is not read; convert it to BVH, for example with Blender")
    selected = by_ending(source)
    if selected is not None and not selected.reads:
        raise UserError(f"'{source}': {_write_only(selected.name)}")
    if selected is not None:
        _recognises(selected, source)  # raises UserError for a table without a heading
        return selected
    sharing = [form for form in available if name.endswith(form.read_endings)]
    fitting = [form for form in sharing if _recognises(form, source)]
    if len(fitting) == 1:
        return fitting[0]
    names = ", ".join(form.name for form in fitting or sharing or available)
    if fitting:
        problem = "it may be of several formats"
    elif sharing:
        problem = f"it is of no known format, with the arrays {', '.join(sorted(names_in(source))) or 'none'}"
    else:
        problem = "its ending is of no known format; a table has one header line and the ending .csv"
    raise UserError(f"'{source}': {problem}; {GIVE_FORMAT}, one of: {names}")


def _recognises(form: Format, source: Path) -> bool:
    size_limit.check_file(source)
    module = _module(form)
    return not hasattr(module, "recognises") or module.recognises(source)


def _module(form: Format) -> Any:
    return import_module(f".{form.module}", __package__)
