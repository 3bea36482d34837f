"""Half of a gait cycle, with [solve] ends = "mirrored": the other half is its mirror image, half a period later.

The figure travels along x. The mirror plane is y = 0.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.tolerances import ROUNDING

from ..errors import UserError
from .mirror import figure_mirror, mirrored_contact, mirrored_keyframe
from .parse import Parsed
from .table import BodyTable, ClipTable, ContactTable, KeyframeTable, PenaltyTable, RootTable, SiteTable

Shift = tuple[float, float, float]
MIRRORED = "mirrored"


def whole_cycle(source: Parsed, figure: Figure) -> Parsed:
    """Return the clip of a whole cycle in place of that of half a cycle; other clips are unchanged.

    The last keyframe of the half has a time and, where the figure travels, a position of the root. Its pose is the
    mirror image of the first one.

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
    mirror, (first, *between, last) = figure_mirror(figure, half, where), half.keyframe
    wrong = last.model_fields_set - {"time", "root"} or last.root.model_fields_set - {"position"}
    if wrong:
        raise UserError(
            f"ends = 'mirrored': the last keyframe is the mirror image of the first; specify only its time and its "
            f"root.position, not '{sorted(wrong)[0]}'"
        )
    start, seconds = first.time, last.time - first.time
    shift = _half_travel(half, first, last)

    def image(row: KeyframeTable) -> KeyframeTable:
        return _moved(mirrored_keyframe(row, figure, mirror), shift).changed(time=row.time + seconds)

    end = _moved(_moved(first, shift), shift).changed(time=start + 2 * seconds)
    rows = [first, *between, image(first), *map(image, between), end]
    contacts = [
        piece
        for row in half.contact
        for one in (row, _later(mirrored_contact(row, figure, mirror), seconds, shift))
        for piece in _pieces(one, start, start + 2 * seconds, shift)
    ]
    penalties = [_repeated(entry, seconds) for entry in half.penalty]
    solve = half.solve.changed(ends="periodic")
    return half.changed(keyframe=rows, contact=contacts, penalty=penalties, solve=solve)


def _half_travel(half: ClipTable, first: KeyframeTable, last: KeyframeTable) -> Shift:
    """Return the displacement [m] of half a cycle, from [solve] travel or the root's positions."""
    if half.solve.travel is not None:
        x, y, z = half.solve.travel
        if y:
            raise UserError(f"ends = 'mirrored': travel = [{x:g}, {y:g}, {z:g}] must be along x, with y = 0")
        return (x / 2, 0.0, z / 2)
    if last.root.position == "free":
        return (0.0, 0.0, 0.0)
    begin = ("free",) * 3 if first.root.position == "free" else first.root.position
    moves = list[float]()
    for axis, a, b in zip("xyz", begin, last.root.position, strict=True):
        if not isinstance(b, str) and isinstance(a, str):
            raise UserError(f"ends = 'mirrored': the first keyframe leaves {axis} of root.position free; specify it")
        moves.append(0.0 if isinstance(a, str) or isinstance(b, str) else b - (-a if axis == "y" else a))
    x, aside, z = moves
    if abs(aside) > ROUNDING:
        raise UserError(
            "ends = 'mirrored': y of root.position in the last keyframe must be 'free', or minus that of the first"
        )
    return (x, 0.0, z)


def _moved(row: KeyframeTable, by: Shift) -> KeyframeTable:
    """Return a keyframe displaced by a vector [m]."""

    def along(place: tuple[float | str, ...]) -> tuple[float | str, ...]:
        return tuple(value if isinstance(value, str) else value + step for value, step in zip(place, by, strict=True))

    def root(table: RootTable) -> RootTable:
        return table if table.position == "free" else table.changed(position=along(table.position))

    def site(value: SiteTable | tuple[float | str, ...]) -> SiteTable | tuple[float | str, ...]:
        return value.changed(position=along(value.position)) if isinstance(value, SiteTable) else along(value)

    def body(table: BodyTable) -> BodyTable:
        return table if table.position is None else table.changed(position=along(table.position))

    return row.changed(
        root=root(row.root),
        roots={name: root(table) for name, table in row.roots.items()},
        sites={name: site(value) for name, value in row.sites.items()},
        bodies={name: body(table) for name, table in row.bodies.items()},
    )


def _later(row: ContactTable, seconds: float, by: Shift) -> ContactTable:
    """Return a contact at a later time [s], displaced by a vector [m]."""
    place = None if row.position is None else tuple(a + b for a, b in zip(row.position, by, strict=True))
    return row.changed(start=row.start + seconds, end=row.end + seconds, position=place)


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
            yield one.changed(start=begin, end=end)


def _repeated(entry: PenaltyTable, seconds: float) -> PenaltyTable:
    """Return a soft constraint with its intervals [s] in both halves."""
    intervals = entry.options.get("intervals")
    if not isinstance(intervals, list):
        return entry
    later = [[begin + seconds, end + seconds] for begin, end in intervals]
    return PenaltyTable.of(entry.kind, **{**entry.options, "intervals": [*intervals, *later]})
