"""Last stage of loading: keyframes of a figure become a problem with soft constraints."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from dynsplines.solver.contacts import Interval
from dynsplines.solver.curve.frame import Frame, TimelineError
from dynsplines.solver.curve.recording import Track
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.penalty import Penalty
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.search.descent import optimiser_of
from dynsplines.solver.search.nlopt_methods import DENSE, is_practical
from dynsplines.solver.surface import static_surfaces

from ..errors import UserError
from ..motion import Saved
from ..scene.assets import Scene
from ..scene.model_notes import model_notes
from .contacts import schedule_of
from .context import Context, knees_and_elbows
from .kinds import KINDS, Options
from .parse import Parsed, table_of
from .table import ClipTable, SolveTable
from .tracking.problem import rests_of, stances_in, stances_of, tracking_context
from .tracking.recording import following_problem, stances_near

CustomPenalties = Sequence[tuple[Penalty, float]]

# end conditions of the spline, and a note on them, by whether the figure is at rest at its start and its end
AT_REST = {
    (True, True): ("clamped", "the start and the end are at rest"),
    (True, False): ("clamped start", "the start is at rest"),
    (False, True): ("clamped end", "the end is at rest"),
}
FREE_NOTE = "; with [solve] ends = 'free', the solver chooses the speed"
NO_CYCLE = "no cycle: that takes three keyframes that fix every joint, not all alike, and one free joint or none"
AROUND = ("travel", "turn")  # keys of [solve] for the displacement of a loop per period


@dataclass(frozen=True, repr=False)
class Clip:
    """A problem that is ready to solve, with the data needed to report on the resulting motion.

    Attributes:
        name: Name of the clip and of output files.
        text: The TOML text; empty for clips from MJCF and NPZ files.
        scene: The complete MJCF of figure and scene, with the files that it refers to.
        fps: Samples per second [1/s] of outputs.
        problem: The input of the solver: figure, keyframes, soft constraints, settings and end conditions.
        context: The inputs of the soft constraints: soles, knees and elbows, contacts, grasps, flights, the gait cycle.
        notes: Lines on missing or doubtful input.
        custom_penalties: Custom soft constraints with their weights, which the problem contains, too. They are not
            stored in files.
    """

    name: str
    text: str
    scene: Scene
    fps: float
    problem: Problem
    context: Context
    notes: tuple[str, ...]
    custom_penalties: tuple[tuple[Penalty, float], ...] = ()

    @property
    def figure(self) -> Figure:
        """The figure: a MuJoCo model as a tree of links."""
        return self.problem.figure

    @property
    def keys(self) -> tuple[Frame, ...]:
        """The keyframes: frames with time [s], state (nq,), and the mask (nq,) of their fixed entries."""
        return tuple(self.problem.keys)

    @property
    def has_recording(self) -> bool:
        """Whether the clip follows a recording, so that most of its frames are not keyframes of its text."""
        return self.context.is_tracking

    @property
    def authored_keys(self) -> tuple[Frame, ...]:
        """The keyframes of the clip's text, without the frames of a recording that it follows."""
        return edits_of(self.keys, table_of(self.text, self.context.where)) if self.has_recording else self.keys

    @property
    def stances(self) -> list[dict[str, object]]:
        """The stances of the recording that the clip follows, in the format of motion files; empty for other clips."""
        return stances_of(self.context.schedule.on_ground) if self.has_recording else []

    @property
    def penalties(self) -> tuple[tuple[Penalty, float], ...]:
        """The soft constraints with their weights."""
        return tuple(self.problem.penalties)

    @property
    def settings(self) -> Settings:
        """The settings of the search."""
        return self.problem.settings

    @property
    def ends(self) -> str:
        """The end conditions of the spline: "free", "clamped", "clamped start", "clamped end" or "periodic"."""
        return self.problem.ends

    @property
    def mjcf(self) -> str:
        """The complete MJCF text."""
        return self.scene.mjcf

    def with_problem(self, **changes: Any) -> Clip:
        """Return the same clip with changed fields of its problem.

        Args:
            **changes: New values of the fields of `dynsplines.solver.problem.Problem`, such as penalties, settings and
                ends.

        Returns:
            The changed clip.
        """
        return replace(self, problem=replace(self.problem, **changes))

    def __repr__(self) -> str:
        """ "<Clip run_and_step: 2.20 s, 13 keyframes (10 partial), 17 penalties, 39 DOF>" """
        seconds, partial = self.keys[-1].time - self.keys[0].time, sum(not key.is_key for key in self.keys)
        partial_note = f" ({partial} partial)" if partial else ""
        loop = ", loop" if self.ends == "periodic" else ""
        return (
            f"<Clip {self.name}: {seconds:.2f} s{loop}, {len(self.keys)} keyframes{partial_note}, "
            f"{len(self.penalties)} penalties, {self.figure.model.nv} DOF>"
        )


def build(source: Parsed, scene: Scene, figure: Figure, keys: Sequence[Frame], fps: float) -> Clip:
    """Return the clip of keyframes, qpos (nq,) and mask each.

    Raises:
        UserError: For keyframes that form no timeline, and for tables that do not fit the figure.
    """
    table, problem = source.table, source.problem(figure, keys)
    _check_problem(problem, source.where)
    surfaces = static_surfaces(figure.model)
    schedule = schedule_of(figure, problem.raw, surfaces, source.where, table.contact, table.grasp)
    context = Context(schedule, source.where, tuple(knees_and_elbows(figure)))
    resting: tuple[str, ...] = ()
    stationary = context.is_stationary_at_ends
    if "ends" not in table.solve.model_fields_set and any(stationary):
        ends, note = AT_REST[stationary]
        problem = replace(problem, ends=ends)
        context, resting = context.with_schedule(keys=problem.raw), (note + FREE_NOTE,)
    context, penalties, notes = constraints(context, source.options)
    problem = replace(problem, penalties=penalties)
    all_notes = (*model_notes(figure.model), *notes, *resting, *_too_many(problem))
    return Clip(source.name, source.text, scene, fps, problem, context, all_notes)


def constraints(
    context: Context, listed: Mapping[str, Options]
) -> tuple[Context, tuple[tuple[Penalty, float], ...], list[str]]:
    """Return the context with the options of the kinds that a clip lists, its soft constraints with their weights, and
    notes for the user.

    Raises:
        UserError: For options that do not fit the figure.
    """
    options = {kind.name: Options() for kind in KINDS.values() if kind.is_default} | dict(listed)
    if "prior" not in listed and context.person is not None and context.person.is_robot:
        del options["prior"]
    if context.is_free_sideways:
        options.setdefault("support", Options())
    notes = [*context.missing_features, *context.drifting_objects, *context.contacts_in_air]
    context = _with_options(context, options, listed.keys())
    if context.schedule.has_cycle and context.schedule.gait_cycle is None:
        notes.append(NO_CYCLE)
    notes += [*context.unmet_falls, *context.missing_steps]
    penalties = list[tuple[Penalty, float]]()
    for name in options:
        kind = KINDS[name]
        terms = list(kind.terms(context, options[name]))
        if name in listed and name != "cycle" and not terms and any(kind.weights(options[name]).values()):
            measured = "; ".join(part.quantity for part in kind.parts)
            notes.append(f"penalty '{name}' has no effect in this clip; it measures: {measured}")
        penalties += terms
    return context, tuple((p, weight) for p, weight in penalties if weight > 0), notes


def _with_options(context: Context, options: Mapping[str, Options], listed: Container[str]) -> Context:
    """Return the context with the options that affect several kinds: points of soles, limbs, flights, the cycle."""
    collision, limits, flight, cycle = (options[kind] for kind in ("collision", "limits", "flight", "cycle"))
    if collision.points is not None:
        context = context.with_schedule(points=context.sites(collision.points))
    if limits.bend_joints is not None:
        context = replace(context, bends=context.limbs(limits.bend_joints))
    has_cycle = (True if "cycle" in listed else None) if KINDS["cycle"].weights(cycle)[""] > 0 else False
    flights = _flights(context, flight.intervals, is_requested="flight" in listed)
    return context.with_schedule(specified_flights=flights, has_cycle=has_cycle, period=cycle.period)


def _flights(
    context: Context, intervals: Sequence[Interval] | None, *, is_requested: bool
) -> tuple[Interval, ...] | None:
    """The flights that a clip specifies; None to infer them. Without surfaces, a requested flight lasts all along."""
    first, last = float(context.keys.times[0]), float(context.keys.times[-1])
    if context.schedule.root is None:
        return None
    if intervals is None:
        return ((first, last),) if is_requested and not context.surfaces else None
    for begin, end in intervals:
        if not first <= begin < end <= last:
            raise UserError(
                f"{context.where}: penalty 'flight': [{begin:g}, {end:g}] is not an interval of the clip, which runs "
                f"from {first:g} to {last:g} s"
            )
    return tuple(intervals)


def build_following(
    source: Parsed,
    scene: Scene,
    recorded: Track,
    edits: Sequence[Frame],
    fps: float,
    stances: object = None,
) -> Clip:
    """Return a clip whose keyframes edit a recording.

    Args:
        recorded: The recording, at times of the clip.
        fps: Samples per second [1/s] of outputs.
        stances: The stances that a file contains, see `Clip.stances`; None: they are inferred.

    Raises:
        UserError: For tables that do not fit the figure or the recording.
    """
    context = tracking_context(recorded.figure, recorded.times, recorded.states, source.where)
    given_rests = rests_of(context, source.table.contact, recorded.path.span)
    rests = stances_near(recorded, context, edits, given_rests) if stances is None else stances_in(stances, context)
    context = context.with_schedule(on_ground=rests)
    assert source.table.recording is not None
    problem = following_problem(recorded, source.table.recording.weight, context, source.options, edits)
    _check_problem(problem, source.where)
    context = context.with_schedule(keys=problem.raw)
    return Clip(source.name, source.text, scene, fps, problem, context, ())


def _check_problem(problem: Problem, where: str) -> None:
    try:
        _ = problem.raw
        optimiser_of(problem.settings.optimiser, problem.figure.width, problem.settings.tolerance)
    except (TimelineError, ValueError) as error:
        raise UserError(f"{where}: {error}") from None


def edits_of(keys: Sequence[Frame], table: ClipTable) -> tuple[Frame, ...]:
    """Return the frames at the times of a clip's keyframe tables, from which those of saved motions differ slightly."""
    times = [row.time for row in table.keyframe]
    return tuple(key for key in keys if np.isclose(key.time, times, rtol=0, atol=1e-6).any())


def solve_of(saved: Saved, solve: SolveTable) -> SolveTable:
    """Return a [solve] table with the ends of a saved motion."""
    return solve.without(*AROUND).model_copy(update={"ends": saved.timeline.ends, **around(saved).specified})


def around(saved: Saved) -> SolveTable:
    """Return the displacement of a saved loop as keys of [solve]: travel [m] and, if it turns, turn [degrees]."""
    roots = saved.figure.tables.position_columns
    if saved.timeline.ends != "periodic" or not roots.size:
        return SolveTable()
    seam = Seam.of(saved.figure, saved.timeline)
    turn = {"turn": float(np.degrees(seam.headings[0]))} if seam.headings[0] else {}
    return SolveTable.without_checks(travel=tuple(seam.travel[roots[:, 0]].tolist()), **turn)


def with_custom_penalties(clip: Clip, added: CustomPenalties) -> Clip:
    """Return the clip with custom soft constraints, each with its weight, appended to its penalties.

    Raises:
        UserError: For an entry that is not a pair of a soft constraint and a weight, and for a name that exists.
    """
    names = {penalty.name for penalty, _ in clip.penalties} | {k.term(part) for k in KINDS.values() for part in k.parts}
    where = f"{clip.name}: custom_penalties"
    for entry in added:
        if not (isinstance(entry, tuple) and len(entry) == 2 and isinstance(entry[0], Penalty)):
            raise UserError(f"{where}: every entry is (penalty, weight), a soft constraint and a number, not {entry!r}")
        penalty, weight = entry
        if isinstance(weight, bool) or not isinstance(weight, int | float) or not 0 <= weight < np.inf:
            raise UserError(f"{where}: the weight of '{penalty.name}' is a number from 0 on, not {weight!r}")
        if penalty.name in names:
            raise UserError(f"{where}: a soft constraint called '{penalty.name}' already exists; give it another name")
        names.add(penalty.name)
    more = tuple((penalty, float(weight)) for penalty, weight in added if weight > 0)
    with_more = clip.with_problem(penalties=(*clip.penalties, *more))
    return replace(with_more, custom_penalties=(*clip.custom_penalties, *more))


def _too_many(problem: Problem) -> Iterator[str]:
    settings = problem.settings
    times = np.array([key.time for key in problem.keys])
    about = settings.beginning(times, in_windows=False).size * problem.figure.width
    if isinstance(settings.optimiser, str) and not is_practical(settings.optimiser, about):
        most = DENSE[settings.optimiser.lower()]
        yield (
            f"optimiser '{settings.optimiser}' is dense: with some {about} unknowns, over {most}, "
            "all steps are Gauss-Newton's and nothing refines them"
        )
