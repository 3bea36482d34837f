"""Selection of the layout in which a file is read, by `evidence`: redundant body poses, or else plausibility.

A reader returns a recording in the documented layout, with `others` for further layouts that occur in such files. The
documented layout has precedence. Another one replaces it only if the documented one contradicts the file's body poses,
or is implausible while the other is plausible. Formats that share an extension have equal precedence. A note reports
the decision. An undecided file is refused, unless the user names the format: then its documented layout is used.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Index
from dynsplines.solver.figure.figure import JointKind

from ..errors import UserError
from ..scene.assets import Scene
from ..scene.configuration import quaternions
from . import missing_input
from .evidence import Plausibility, disagreement, in_degrees
from .skeleton import hierarchy
from .skeleton.up_axis import TO_Z
from .trajectory import BodyPoses, Recording

EQUAL = 0.05  # difference in `Disagreement.share` up to which layouts agree equally well with body poses
SAME = 1e-6  # [m, rad] largest difference between layouts that result in the same motion
ABOUT_X = quat.from_rotation_vector(np.array([np.pi / 2, 0, 0]))
Y_UP = (  # words; rotation to z up; whether the root's frame is y up, too
    ("y up", ABOUT_X, False),
    ("y up in the world and in the root's frame", ABOUT_X, True),
    ("y up and z forward in the world and in the root's frame", TO_Z["y"], True),
)
Reading = Callable[[], Array]
Change = tuple[str, Callable[[Array], Array]]
Candidate = tuple[str, Recording]  # name of a format, and the file read in it
Judged = tuple[Plausibility, Candidate]


def recording(
    model: mujoco.MjModel,
    time: Array,
    readings: Mapping[tuple[str, ...], Reading],
    *,
    scalar_last: bool | None = None,
    has_names: bool = True,
    bodies: BodyPoses | None = None,
    fps: float | None = None,
    loops: bool = False,
) -> Recording:
    """Return a recording with the layouts that its file may have.

    Args:
        time: (T,) [s].
        readings: Functions that return qpos (T, nq), wxyz, by words that describe their layout. The documented one,
            without words, is first. A function that raises UserError does not fit the file.
        scalar_last: Whether quaternions are documented as xyzw; None where their order is certain.
        has_names: Whether the file names its joints, so that their order is certain.

    Raises:
        UserError: The first of the readings' errors, if none fits.
    """
    bases: list[Recording] = []
    failure: UserError | None = None
    for layout, read in readings.items():
        try:
            base = Recording(time, read(), fps=fps, loops=loops, layout=layout, bodies=bodies)
        except UserError as error:
            failure = failure or error
        else:
            bases.append(_in_radians(model, base))
    if not bases:
        assert failure is not None, "a file has a documented layout"
        raise failure
    variants = [other for base in bases for other in _variants(model, base, scalar_last, has_names=has_names)]
    return replace(bases[0], others=(*bases[1:], *variants))


def with_notes(recorded: Recording, notes: Sequence[str]) -> Recording:
    """Return a recording with further notes, in all of its layouts."""
    others = tuple(replace(other, notes=(*other.notes, *notes)) for other in recorded.others)
    return replace(recorded, notes=(*recorded.notes, *notes), others=others)


def chosen(
    recordings: Mapping[str, Recording], model: mujoco.MjModel | None, where: object, *, is_named: bool = False
) -> Recording:
    """Return the recording in the layout with the most evidence, with a note if there was a choice.

    Args:
        recordings: By format; several for a file that several formats fit.
        model: The figure; None for files that contain theirs.
        where: Label of the file in errors.
        is_named: Whether the user names the format, so that its documented layout is used if several are possible.

    Raises:
        UserError: No layout agrees with the file's body poses, or several are equally plausible.
    """
    first = next(iter(recordings.values()))
    if len(recordings) == 1 and not first.others and first.bodies is None:
        return first
    if model is None:
        assert first.mjcf is not None, "a file without a figure is for one that is named"
        model = Scene(first.mjcf, first.assets).model()
    layouts = [(form, variant) for form, base in recordings.items() for variant in (base, *base.others)]
    fitting, notes = _agreeing(layouts, model, where)
    best, note = _most_plausible(fitting, model, where, is_named=is_named)
    return replace(best, bodies=None, others=(), notes=(*best.notes, *notes, *note))


def _agreeing(
    candidates: Sequence[Candidate], model: mujoco.MjModel, where: object
) -> tuple[list[Candidate], tuple[str, ...]]:
    """Return the layouts that reproduce the body poses best, and a note if the documented one is not among them."""
    verified = [(form, variant) for form, variant in candidates if variant.bodies is not None]
    if not verified:
        return list(candidates), ()
    off = [disagreement(model, variant) for _, variant in verified]
    best, first = min(off, key=lambda each: each.share), off[0]
    if best.share > 1:
        others = f", at best {best} with {_layout_text(verified[off.index(best)][1])}" if best is not first else ""
        raise UserError(
            f"{where}: its body poses differ from the figure's at its joint angles, by up to {first}{others}; "
            "name the model that it was recorded with"
        )
    out = [candidate for candidate, one in zip(verified, off, strict=True) if one.share <= best.share + EQUAL]
    simplest = min(out, key=lambda each: len(each[1].layout))
    if not simplest[1].layout:
        return out, ()
    before = "" if verified[0][1].layout else f"; as documented {first}"
    return out, (f"read as {_layout_name(*simplest)}: its body poses differ from the figure's by up to {best}{before}",)


def _most_plausible(
    candidates: Sequence[Candidate], model: mujoco.MjModel, where: object, *, is_named: bool
) -> tuple[Recording, tuple[str, ...]]:
    """Return the layout to use with a note: the documented one, unless another refutes it."""
    least = min(len(variant.layout) for _, variant in candidates)
    documented = _judged([candidate for candidate in candidates if len(candidate[1].layout) == least], model)
    first = documented[0]
    rivals = _doubts(first, candidates, model, least)
    if rivals:
        best = _best(rivals)
        is_refuted = first[0].is_refuted_by(best[0][0])
        if is_refuted and len(best) == 1:
            return best[0][1][1], (_decided(best[0], first),)
        if not is_named:
            raise UserError(f"{where}: {_doubted(first, best)}")
        return first[1][1], (_decided(first, best[0]),)
    if len(documented) == 1:
        return first[1][1], ()
    best = _best(documented)
    if len(best) > 1:
        raise UserError(f"{where}: {_equally(best)}")
    other = next(entry for entry in documented if entry is not best[0])
    return best[0][1][1], (_decided(best[0], other),)


def _doubts(first: Judged, candidates: Sequence[Candidate], model: mujoco.MjModel, least: int) -> list[Judged]:
    """Return the clearly more plausible layouts that deviate more from the documented one, the most plausible first."""
    if first[0].is_evident:
        return []
    axes = [other for candidate in candidates for other in _axes(model, candidate)]
    others = _judged([entry for entry in (*candidates, *axes) if len(entry[1].layout) > least], model)
    return [judged for judged in others if first[0].is_doubted_by(judged[0])]


def _best(ranked: Sequence[Judged]) -> list[Judged]:
    """Return the layouts of fewest deviations that the most plausible one does not exclude. If in one of these the feet
    slide evidently less than in the others, it is the only result."""
    near = [ranked[0], *(judged for judged in ranked[1:] if not judged[0].is_doubted_by(ranked[0][0]))]
    fewest = min(len(variant.layout) for _, (_, variant) in near)
    near = [judged for judged in near if len(judged[1][1].layout) == fewest]
    at_rest = [one for one in near if all(one is other or one[0].slides_less_than(other[0]) for other in near)]
    return at_rest or near


def _decided(used: Judged, other: Judged) -> str:
    return f"read as {_layout_name(*used[1])}: {used[0]}; as {_layout_name(*other[1])} it would be: {other[0]}"


def _doubted(first: Judged, best: Sequence[Judged]) -> str:
    """Return the error for a doubtful documented layout that no single other one replaces."""
    form = first[1][0]
    do = f"convert the file, or {missing_input.FORMAT}: {form} reads it as documented"
    if len(best) > 1:
        names = " and ".join(_layout_name(*candidate) for _, candidate in best)
        return f"as {form} it is implausible ({first[0]}); {names} are equally plausible ({best[0][0]}); {do}"
    return f"as {form} it is doubtful ({first[0]}); as {_layout_name(*best[0][1])} it would be: {best[0][0]}; {do}"


def _equally(rivals: Sequence[Judged]) -> str:
    names = " and ".join(_layout_name(*candidate) for _, candidate in rivals)
    forms = list(dict.fromkeys(form for _, (form, _) in rivals))
    do = f"{missing_input.FORMAT}, one of: {', '.join(forms)}" if len(forms) > 1 else "convert the file to one of these"
    return f"{names} are equally plausible ({rivals[0][0]}), and differ; {do}"


def _judged(candidates: Sequence[Candidate], model: mujoco.MjModel) -> list[Judged]:
    """Return layouts, the most plausible first; of equivalent ones only that of fewest deviations."""
    out: list[Judged] = []
    for form, variant in sorted(candidates, key=lambda each: len(each[1].layout)):
        if not any(_is_same(model, variant, other) for _, (_, other) in out):
            out.append((Plausibility.of(model, variant), (form, variant)))
    return sorted(out, key=lambda each: -each[0].score)


def _is_same(model: mujoco.MjModel, one: Recording, other: Recording) -> bool:
    """Return whether two layouts result in the same motion, up to the signs of quaternions."""
    if one.qpos.shape != other.qpos.shape:
        return False
    apart = one.qpos - other.qpos
    for columns in quaternions(model).values():
        a, b = one.qpos[:, columns], other.qpos[:, columns]
        apart[:, columns] = np.where(np.sum(a * b, axis=1, keepdims=True) < 0, a + b, a - b)
    return not np.any(np.abs(apart) > SAME)


def _layout_name(form: str, recorded: Recording) -> str:
    return f"{form} with {_layout_text(recorded)}" if recorded.layout else form


def _layout_text(recorded: Recording) -> str:
    return " and ".join(recorded.layout)


def _variants(
    model: mujoco.MjModel, base: Recording, scalar_last: bool | None, *, has_names: bool
) -> Iterator[Recording]:
    """Yield the layouts that deviate from one by the order of quaternions and joints, the smallest deviation first."""
    changes: list[Change] = []
    if scalar_last is not None and quaternions(model):
        shift = -1 if scalar_last else 1
        changes.append((f"quaternions {'wxyz' if scalar_last else 'xyzw'}", lambda qpos: _rolled(model, qpos, shift)))
    order = None if has_names else breadth_first(model)
    if order is not None:
        columns = model.jnt_qposadr
        changes.append(("joints breadth first", lambda qpos: _moved(qpos, columns[np.sort(order)], columns[order])))
    for count in range(1, len(changes) + 1):
        for combination in combinations(changes, count):
            qpos = base.qpos
            for _, change in combination:
                qpos = change(qpos)
            yield replace(base, qpos=qpos, layout=(*base.layout, *(words for words, _ in combination)))


def _rolled(model: mujoco.MjModel, qpos: Array, shift: int) -> Array:
    out = qpos.copy()
    for columns in quaternions(model).values():
        out[:, columns] = np.roll(qpos[:, columns], shift, axis=1)
    return out


def _moved(qpos: Array, source: Index, target: Index) -> Array:
    out = qpos.copy()
    out[:, target] = qpos[:, source]
    return out


def _in_radians(model: mujoco.MjModel, recorded: Recording) -> Recording:
    """Convert a recording whose hinges are evidently in degrees, with a note; return others unchanged."""
    if not in_degrees(model, recorded.qpos, recorded.time):
        return recorded
    hinges = model.jnt_qposadr[model.jnt_type == JointKind.HINGE]
    most = np.nanmax(np.abs(recorded.qpos[:, hinges]))
    qpos = recorded.qpos.copy()
    qpos[:, hinges] = np.radians(qpos[:, hinges])
    return replace(recorded, qpos=qpos, notes=(*recorded.notes, f"angles go to {most:.0f}: read as degrees"))


def breadth_first(model: mujoco.MjModel) -> Index | None:
    """Return hinges and slides in breadth-first order from the root, as Isaac has them.

    None if that is MuJoCo's order, and for figures with ball joints, which no program with that order has.
    """
    if JointKind.BALL in model.jnt_type:
        return None
    joints = np.flatnonzero(model.jnt_type != JointKind.FREE)
    above = []
    for joint in joints:
        body = int(model.jnt_bodyid[joint])
        carriers = hierarchy.above(model, body)
        above.append(int(joint - model.body_jntadr[body]) + int(model.body_jntnum[carriers].sum()))
    order = np.argsort(above, kind="stable")
    return None if np.array_equal(order, np.arange(joints.size)) else joints[order]


def _axes(model: mujoco.MjModel, candidate: Candidate) -> Iterator[Candidate]:
    """Yield the same layouts with y up; in a file with body poses, the root's frame is that of the figure."""
    form, base = candidate
    if JointKind.FREE not in model.jnt_type:
        return
    for words, turn, turns_root in Y_UP:
        if turns_root and base.bodies is not None:
            continue
        qpos = base.qpos.copy()
        for start in model.jnt_qposadr[model.jnt_type == JointKind.FREE]:
            qpos[:, start : start + 3] = quat.rotated(turn, qpos[:, start : start + 3])
            rotation = quat.product(turn, qpos[:, start + 3 : start + 7])
            qpos[:, start + 3 : start + 7] = quat.product(rotation, quat.conjugate(turn)) if turns_root else rotation
        yield form, replace(base, qpos=qpos, layout=(*base.layout, words))
