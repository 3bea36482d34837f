"""Half of a gait cycle, with [solve] ends = "mirrored": the other half is its mirror image, half a period later.

The figure travels along x. The mirror plane is y = 0.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.tolerances import ROUNDING

from ..errors import UserError
from .mirror import figure_mirror, mirrored_tables
from .parse import Parsed
from .table import BodyTable, ClipTable, ContactTable, KeyframeTable, PenaltyTable, RootTable

Shift = tuple[float, float, float]
MIRRORED = "mirrored"


def whole_cycle(source: Parsed, figure: Figure) -> Parsed:
    """Return the clip of a whole cycle in place of that of half a cycle; other clips are unchanged.

    The last keyframe of the half has a time alone, because it is the mirror image of the first one.

    Raises:
        UserError: For a figure without left and right sides, or a half cycle without a mirror image.
    """
    if source.table.solve.ends != MIRRORED:
        return source
    try:
        table = _whole(source.table, figure, source.where)
    except UserError as error:
        text = str(error)
        raise UserError(text if text.startswith(source.where) else f"{source.where}: {text}") from None
    whole = replace(source, table=table)
    return whole.with_solve(table.solve, [row.time for row in table.keyframe])


def _whole(half: ClipTable, figure: Figure, where: str) -> ClipTable:
    if half.grasp:
        raise UserError("ends = 'mirrored': [[grasp]] is not for half a cycle; write the keyframes of the whole cycle")
    if half.solve.turn:
        raise UserError("ends = 'mirrored': a figure that turns has no mirrored half; remove turn")
    mirror, (first, *between, last) = figure_mirror(figure, half, where), _with_roots(figure, half.keyframe)
    if last.model_fields_set != {"time"}:
        raise UserError(
            "ends = 'mirrored': the last keyframe is the mirror image of the first; specify only its time, and the "
            "displacement of the whole cycle as travel = [x, 0, z] in [solve]"
        )
    x, y, z = (0.0, 0.0, 0.0) if half.solve.travel is None else half.solve.travel
    if y or (half.solve.travel is None and first.root.position != "free"):
        raise UserError("ends = 'mirrored': give travel = [x, 0, z] in [solve], the displacement of the whole cycle")
    start, seconds, shift = first.time, last.time - first.time, (x / 2, 0.0, z / 2)
    image = mirrored_tables(half.change(keyframe=[first, *between], penalty=[]), figure, mirror)
    images = [_move(row, shift).change(time=row.time + seconds) for row in image.keyframe]
    end = _move(_move(first, shift), shift).change(time=start + 2 * seconds)
    contacts = [
        piece
        for row, other in zip(half.contact, image.contact, strict=True)
        for one in (row, _later(other, seconds, shift))
        for piece in _pieces(one, start, start + 2 * seconds, shift)
    ]
    penalties = [_repeat(entry, seconds) for entry in half.penalty]
    solve = half.solve.change(ends="periodic")
    return half.change(keyframe=[first, *between, *images, end], contact=contacts, penalty=penalties, solve=solve)


def _with_roots(figure: Figure, rows: Sequence[KeyframeTable]) -> list[KeyframeTable]:
    """Return keyframes that name the position of the root if `others` takes it from the model."""
    if figure.root is None:
        return list(rows)
    out, first = list[KeyframeTable](), figure.links[figure.root.link].qpos
    for row in rows:
        qpos = figure.model.qpos0 if row.model_key is None else figure.model.key(row.model_key).qpos
        is_from_model = row.others == "rest" or row.model_key is not None
        if is_from_model and not row.roots and "position" not in row.root.model_fields_set:
            row = row.change(root=row.root.change(position=tuple(qpos[first : first + 3].tolist())))
        out.append(row)
    return out


def _move(row: KeyframeTable, by: Shift) -> KeyframeTable:
    """Return a keyframe displaced by a vector [m]."""

    def along(place: tuple[float | str, ...]) -> tuple[float | str, ...]:
        return tuple(value if isinstance(value, str) else value + step for value, step in zip(place, by, strict=True))

    def root(table: RootTable) -> RootTable:
        return table if table.position == "free" else table.change(position=along(table.position))

    def body(table: BodyTable) -> BodyTable:
        return table if table.position is None else table.change(position=along(table.position))

    return row.change(
        root=root(row.root),
        roots={name: root(table) for name, table in row.roots.items()},
        sites={name: along(value) for name, value in row.sites.items()},
        bodies={name: body(table) for name, table in row.bodies.items()},
    )


def _later(row: ContactTable, seconds: float, by: Shift) -> ContactTable:
    """Return a contact at a later time [s], displaced by a vector [m]."""
    place = None if row.position is None else tuple(a + b for a, b in zip(row.position, by, strict=True))
    return row.change(start=row.start + seconds, end=row.end + seconds, position=place)


def _pieces(row: ContactTable, first: float, last: float, half: Shift) -> Iterator[ContactTable]:
    """Yield the parts of a contact within a cycle [s]; what exceeds its end continues at its start, a cycle earlier."""
    if row.start < first - ROUNDING or row.end > row.start + last - first + ROUNDING:
        yield row  # an error of the clip, reported like that of any other
        return
    x, _, z = half
    earlier = _later(row, first - last, (-2 * x, 0.0, -2 * z))
    for one in (row, earlier):
        begin, end = max(one.start, first), min(one.end, last)
        if end - begin > ROUNDING:
            yield one.change(start=begin, end=end)


def _repeat(entry: PenaltyTable, seconds: float) -> PenaltyTable:
    """Return a soft constraint with its intervals [s] in both halves."""
    intervals = entry.options.get("intervals")
    if not isinstance(intervals, list):
        return entry
    later = [[begin + seconds, end + seconds] for begin, end in intervals]
    return PenaltyTable.of(entry.kind, **{**entry.options, "intervals": [*intervals, *later]})
