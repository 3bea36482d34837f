"""The loop of the solver process: a text in; its keyframes, every better path and its violations out.

A message during a search ends it. The best path so far is the initial guess of the next search.
"""

from __future__ import annotations

import _thread
import os
import pickle
import signal
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace
from multiprocessing.connection import Connection
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING, Any, Protocol, TypedDict

import numpy as np

from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.inbetween import continue_from, inbetween
from dynsplines.solver.one_thread import one_thread
from dynsplines.solver.refine.warm_start import warm_start
from dynsplines.solver.search.minimum import Stop, StopSearch
from dynsplines.solver.search.restart_criteria import is_poor_minimum
from dynsplines.solver.search.selection import select_best
from dynsplines.solver.solution import Improvement, Solution

from ... import recordings
from ...clip.build import Clip
from ...clip.parse import table_of
from ...errors import UserError, one_line
from ...scene.file_access import allowed
from ...system.cache_folder import place as cache
from .. import paths
from ..outline import formats, kinds, outline
from ..solver import Message
from .speculation import Speculation
from .stage import stage

if TYPE_CHECKING:
    Line = Connection[Any, Any]

MOST_SEEN = 40  # number of texts whose paths are cached
IDLE = 1.0  # [s] idle time after which a suspect result is searched again from the raw spline
DEARER = 3.0  # [1] ratio of E to that of the previous result above which a result is suspect
SOONEST = 0.04  # [s] minimum interval between paths sent
QUICK = 0.3  # [s] loading time above which clips are not solved speculatively, because an edit would wait


def serve(line: Line, outside: bool) -> None:
    """Run until the other end of the connection is closed. Only the server handles Ctrl-C in the terminal."""
    inbox: SimpleQueue[Message | None] = SimpleQueue()
    work = Work(line)
    work.is_awaited = lambda: not inbox.empty()
    signal.signal(signal.SIGINT, work.interrupted)
    threading.Thread(target=_read, args=(line, inbox, work), daemon=True).start()
    line.send({"is": "kinds", "kinds": kinds()})
    with suppress(BrokenPipeError, EOFError, OSError), allowed(outside), one_thread():
        while (message := _next(inbox, work)) is not None:
            work.do(message)
    os._exit(0)


def _next(inbox: SimpleQueue[Message | None], work: Work) -> Message | None:
    """Return the next message. During idle time a suspect result is searched again."""
    while work.may_look:
        with suppress(Empty):
            return inbox.get(timeout=IDLE)
        work.do({"do": "look"})
    return inbox.get()


def _read(line: Line, inbox: SimpleQueue[Message | None], work: Work) -> None:
    """Receive messages; each interrupts a running search."""
    with suppress(EOFError, OSError):
        while True:
            message = line.recv()
            inbox.put(message)
            work.interrupt()
    inbox.put(None)
    work.interrupt()


class Outlet(Protocol):
    """The receiver of messages."""

    def send(self, obj: Any, /) -> None:
        """Send one message completely."""
        ...


class Work:
    """A clip, the best path through its keyframes, and the connection to the server."""

    def __init__(self, line: Outlet) -> None:
        self.line = line
        self.clip: Clip | None = None
        self.found: Solution | None = None
        self.revision = 0
        self._is_searching = self._is_sending = self._is_asked = False
        self._owes_raw = self._has_told = False
        self._sent = 0.0
        self.has_curves = False
        self.seen: dict[str, Timeline] = {}
        self.is_awaited: Callable[[], bool] = lambda: False  # whether a message is waiting
        self._is_going, self._is_near = True, False
        self._is_cut = False  # whether a message has interrupted the last search
        self._astray: str | None = None
        self._speculation: Speculation | None = None
        self._took = 0.0  # [s] loading time of the last edit
        self._before: tuple[float, int] | None = None  # E and the number of violations of the last good result

    def do(self, message: Message) -> None:
        """Handle one message; errors are reported to the page."""
        try:
            getattr(self, f"do_{message['do']}")(**{key: value for key, value in message.items() if key != "do"})
        except UserError as error:
            self._tell("refused", revision=message.get("revision"), words=one_line(error))
        except Exception as error:  # an internal error, which the page shows before it continues
            words = f"internal error: {type(error).__name__}: {one_line(error)}"
            self._tell("refused", revision=message.get("revision"), words=words)
        except KeyboardInterrupt:  # it arrived at the end of a search, after the handler
            self._is_searching, self._is_cut = False, True
        if self._is_cut and self._is_going and not self.is_awaited():
            self._go_on()  # the message that ended the search did not replace the clip

    def do_load(
        self,
        text: str,
        name: str,
        place: str,
        folder: str,
        revision: int,
        go: bool,
        first: bool,
        found: bytes | None = None,
    ) -> None:
        """Load a text and send its clip and keyframes; then search from the path nearest to the present one.

        Args:
            go: Whether to search.
            first: Whether the text was just opened.
            found: The initial path after a restart of this process, pickled.
        """
        self._is_going, self._astray = go, None
        before, solution = self.clip, self.found
        ahead, self._speculation = self._speculation, None
        if ahead is not None and (first or found is not None or not ahead.is_of(text, before)):
            ahead = None
        clip = ahead.clip if ahead is not None else self._loaded(text, name, place, folder, None if first else before)
        has_ground = before is not None and clip.figure is before.figure
        self.clip, self.revision, self._is_cut = clip, revision, False
        if not has_ground:
            figure = pickle.dumps((clip.scene, clip.figure.coordinates))
            self._send({"is": "stage", "stage": stage(clip), "figure": figure})
        content = outline(text, place)
        self._tell("loaded", revision=revision, notes=list(clip.notes), outline=content, **_shape(clip))
        self._owes_raw = True
        if ahead is not None:
            self._take_up(ahead, go=go)
            return
        path = None if found is None else pickle.loads(found)  # data of this program only
        begin, between = self._begin(clip, before, solution, first=first, found=path)
        if begin is None:
            self._first(clip, go=go)
            return
        self.found = Solution(clip.figure, clip.problem.objective, begin, clip.problem.raw)
        self._send_path(begin, "carried")
        if go:
            self._search(begin, between)
        else:
            self._judge(stop="paused")

    def _loaded(self, text: str, name: str, place: str, folder: str, like: Clip | None) -> Clip:
        """Return the clip of a text, reusing parts of the clip from which it was edited. Raises UserError."""
        begun = time.monotonic()
        clip = recordings.from_text(text, name=name, where=place, folder=Path(folder), like=like)
        self._took = time.monotonic() - begun if like is not None else 0.0  # the figure was reused
        return clip

    def do_speculate(self, text: str, name: str, place: str, folder: str) -> None:
        """Solve speculatively for a text. Any message ends this. The result is used when the text arrives."""
        before, self._speculation = self.clip, None
        if before is None or not self._is_going or self._took > QUICK:
            return
        with suppress(Exception):  # reported when the text arrives
            clip = self._loaded(text, name, place, folder, before)
            begin, between = self._begin(clip, before, self.found, first=False, found=None)
            if clip.figure is before.figure and begin is not None:
                ahead = self._speculation = Speculation(before, clip, begin, between)
                solution = self._lowered(clip, begin, between, lambda improvement: None)
                if solution is not None and solution.evaluations > 1:  # the first evaluation is the initial guess
                    self._speculation = replace(ahead, found=solution)

    def do_wait(self) -> None:
        """Do nothing: the message itself has ended the speculative solve."""

    def _take_up(self, known: Speculation, *, go: bool) -> None:
        """Continue with a speculatively solved clip and its result."""
        clip, solution = known.clip, known.found
        if solution is None:
            self.found = Solution(clip.figure, clip.problem.objective, known.begin, clip.problem.raw)
            self._send_path(known.begin, "carried")
        else:
            self._is_near = True
            self._take(solution)
        stop = Stop.INTERRUPTED if solution is None else solution.stop
        if go and stop is Stop.INTERRUPTED:
            self._search(known.begin if solution is None else solution.timeline, known.between)
        else:
            self._judge(stop=stop.name if go else "paused")

    def _begin(
        self, clip: Clip, before: Clip | None, solution: Solution | None, *, first: bool, found: Timeline | None
    ) -> tuple[Timeline | None, tuple[float, float] | None]:
        """Return the initial guess for a clip, and the edited interval; None if everything is new."""
        cached = self.seen.get(clip.text)
        if cached is not None and not first:  # undo or redo
            return cached, None if before is None else _edited(before, clip)
        timeline = found if found is not None else None if solution is None else solution.timeline
        keys = clip.keys if before is None else before.keys
        if (
            first
            or timeline is None
            or clip.has_recording
            or timeline.width != clip.figure.width
            or timeline.ends != clip.ends
        ):
            return None, None
        turn = clip.problem.turn
        travel = None if clip.problem.travel is None else np.asarray(clip.problem.travel, float)
        try:
            begin = warm_start(clip.figure, timeline, keys, clip.keys, clip.problem.raw, travel, turn)
        except ValueError:
            return None, None
        return begin, _edited(before, clip)

    def _first(self, clip: Clip, *, go: bool) -> None:
        """Show a newly opened clip: its cached solution, or a search from the raw spline."""
        self._send_path(clip.problem.raw, "carried")  # a first view
        from ... import solve_cache  # imported late: the figure is already shown

        folder = cache()
        cached = None if folder is None else solve_cache.read(folder / f"{solve_cache.key_of(clip)}.npz", clip)
        raw = clip.problem.raw
        self.found = Solution(clip.figure, clip.problem.plain_objective, raw, raw) if cached is None else cached.motion
        if cached is not None:
            self._send_path(
                cached.motion.timeline, "found", value=cached.motion.trace[-1][2] if cached.motion.trace else 0
            )
            self._judge(stop=cached.motion.stop.name)
        elif go:
            self._search(None, None)
        else:
            self._judge(stop="paused")

    def do_go(self, anew: bool = False) -> None:
        """Continue the search from the present path, or restart from the raw spline."""
        self._is_going, self._astray = True, None
        self._go_on(anew=anew)

    def _go_on(self, *, anew: bool = False) -> None:
        if self.clip is not None and self.found is not None:
            fresh = anew or self.found.timeline is self.found.raw
            self._search(None if fresh else self.found.timeline, None)

    def do_stop(self) -> None:
        """Keep the search stopped: the message itself has ended it."""
        self._is_going = False

    def do_curves(self, on: bool) -> None:
        """Switch the curves on or off; computing them takes a moment."""
        self.has_curves = on
        if on:
            self._send_curves()

    def do_keep(self, file: str) -> None:
        """Write the present motion to a file for further use."""
        clip, solution = self.clip, self.found
        if clip is None or solution is None:
            raise UserError("nothing has been solved yet")
        from ... import motion
        from ...solving import Solved
        from ...system.progress import Progress

        saved = Solved(clip, solution, None).saved(Progress(), with_report=False)
        motion.save(saved, Path(file))
        self._tell("kept", file=file)

    def interrupt(self) -> None:
        """End the running search, from another thread."""
        if self._is_searching:
            _thread.interrupt_main()

    def interrupted(self, number: int, frame: object) -> None:
        """Handle an interrupt during a search only: it can arrive a moment late."""
        if self._is_sending:
            self._is_asked = True
        elif self._is_searching:
            raise KeyboardInterrupt

    def _send(self, message: Message) -> None:
        """Send a message completely: an interrupt waits."""
        self._is_sending = True
        try:
            self.line.send(message)
        finally:
            self._is_sending = False

    @contextmanager
    def _searching(self) -> Iterator[None]:
        self._is_searching, self._is_asked = True, False
        try:
            yield
        except KeyboardInterrupt:
            self._is_searching = False
        finally:
            self._is_searching = False

    def _heed(self) -> None:
        """End a search at its start if a message arrived just before it, because nothing else would interrupt it."""
        if self.is_awaited():
            raise KeyboardInterrupt

    def _search(self, begin: Timeline | None, between: tuple[float, float] | None) -> None:
        """Minimise E and send every better path. The best path is used, however the search ends."""
        clip = self.clip
        assert clip is not None
        self._tell("searching", revision=self.revision)
        self._is_near = begin is not None
        self._is_cut = False

        def improved(improvement: Improvement) -> None:
            if begin is not None and improvement.evaluation == 1:
                return  # the initial guess is already shown
            if time.monotonic() - self._sent >= SOONEST:
                self._send_path(improvement.build(), "found", **_course(improvement))
                self._send_raw()

        solution = self._lowered(clip, begin, between, improved)
        self._is_cut = solution is None or solution.stop is Stop.INTERRUPTED
        if solution is None:
            self._judge(stop="INTERRUPTED")
            return
        self._take(solution)
        if begin is None and solution.stop is Stop.CONVERGED and (folder := cache()) is not None:
            from ... import solve_cache
            from ...solving import Solved

            solve_cache.write(Solved(clip, solution, None), folder / f"{solve_cache.key_of(clip)}.npz")
        self._judge(stop=solution.stop.name)

    def _lowered(
        self,
        clip: Clip,
        begin: Timeline | None,
        between: tuple[float, float] | None,
        improved: Callable[[Improvement], None],
    ) -> Solution | None:
        """Return the result of a search, also if a message interrupts it; None if it had no result yet.

        Args:
            begin: The initial guess; None: the raw spline.
            between: The edited interval [s]; None: the whole clip.
            improved: Receives every better path.
        """
        best: list[Improvement] = []

        def seen(improvement: Improvement) -> None:
            best[:] = [improvement]
            improved(improvement)
            if self._is_asked or self.is_awaited():
                raise StopSearch

        with self._searching():
            self._heed()
            if begin is None:
                return inbetween(clip.problem, improved=seen)
            return continue_from(clip.problem, begin, between=() if between is None else (between,), improved=seen)
        if not best:
            return None
        return Solution(clip.figure, clip.problem.objective, best[0].build(), clip.problem.raw, stop=Stop.INTERRUPTED)

    def _take(self, found: Solution) -> None:
        clip = self.clip
        assert clip is not None
        self.found = found
        self._remember(clip.text, found.timeline)
        value, parts = (found.trace[-1][2], found.trace[-1][3]) if found.trace else (0.0, {})
        self._send_path(found.timeline, "found", value=value, parts=_plain(parts), evaluation=found.evaluations)

    def _remember(self, text: str, timeline: Timeline) -> None:
        """Cache the path of a text, for undo and redo, for the last few texts."""
        self.seen.pop(text, None)
        self.seen[text] = _bare(timeline)
        if len(self.seen) > MOST_SEEN:
            del self.seen[next(iter(self.seen))]

    def _judge(self, stop: str) -> None:
        """Send the present path's violations, and the reason for the end of the search."""
        clip, solution = self.clip, self.found
        assert clip is not None and solution is not None
        self._send_raw()
        from ...measure.violation import plain, violations

        wrong = violations(clip, solution.timeline, solution.raw)
        self._astray = self._suspected(len(wrong)) if stop in (Stop.CONVERGED.name, Stop.NO_PROGRESS.name) else None
        if not self._has_told:
            self._has_told = True
            self._tell("formats", **formats())
        self._tell(
            "settled",
            revision=self.revision,
            stop=stop,
            violations=plain(wrong),
            frames=solution.timeline.times.tolist(),
            astray=self._astray,
        )
        if self.has_curves:
            self._send_curves()

    def _suspected(self, wrong: int) -> str | None:
        """Return why the minimum near the previous path may be a poor one; None if there is no sign of it."""
        clip, solution = self.clip, self.found
        assert clip is not None and solution is not None
        if not solution.trace:
            return None
        value, parts = solution.trace[-1][2:]
        before, reason = self._before, None
        if self._is_near and before is not None:
            if value > DEARER * before[0]:
                reason = f"E rose to {value:.3g} from {before[0]:.3g}"
            elif wrong > before[1]:
                reason = f"more is wrong than before, {wrong} instead of {before[1]}"
            elif is_poor_minimum(clip.problem.objective, solution.timeline, parts):
                reason = "what constraints cost exceeds what the motion does"
        if reason is None:
            self._before = value, wrong
            return None
        return f"{reason}: the search may have ended in a bad place. It looks elsewhere when nothing else is done."

    @property
    def may_look(self) -> bool:
        """Whether the present result is suspect, and the search was not stopped."""
        return self._is_going and self._astray is not None

    def do_look(self) -> None:
        """Search again from the raw spline in the background, once. The result is used if it is better."""
        clip, now = self.clip, self.found
        assert clip is not None and now is not None
        solution: Solution | None = None
        with self._searching():
            self._heed()
            solution = inbetween(clip.problem)
        if solution is None or solution.stop is Stop.INTERRUPTED:
            return
        self._is_near = False
        objective = clip.problem.objective
        if select_best(objective, [now.timeline, solution.timeline]) is solution.timeline:
            self._take(solution)
            value = solution.trace[-1][2]
            self._tell("note", words=f"a restarted search found a better path: E {value:.3g}")
        self._judge(stop=solution.stop.name)

    def _send_curves(self) -> None:
        if self.clip is not None and self.found is not None:
            from .curves import curves  # imported late: curves are rarely shown

            self._tell("curves", curves=curves(self.clip, self.found))

    def _send_raw(self) -> None:
        """Send the raw spline, once per text, after more urgent messages."""
        if self._owes_raw and self.clip is not None:
            self._owes_raw = False
            self._send_path(self.clip.problem.raw, "raw")

    def _send_path(self, timeline: Timeline, stage: str, **told: Any) -> None:
        """Send a path: as the page plays it, and pickled for the server, which adds keyframes from it."""
        clip = self.clip
        assert clip is not None
        self._sent = time.monotonic()
        header = {"is": "path", "kind": stage, "revision": self.revision, **told}
        header["frames"] = [round(float(t), 5) for t in timeline.times]
        data = paths.packed(clip.figure, timeline, header)
        packed = pickle.dumps(_bare(timeline))
        self._send({"is": "path", "kind": stage, "revision": self.revision, "data": data, "timeline": packed, **told})

    def _tell(self, what: str, **details: Any) -> None:
        self._send({"is": what, **details})


def _bare(timeline: Timeline) -> Timeline:
    """Return a timeline without caches derived from its times."""
    return Timeline(timeline.frames, timeline.end_slope, timeline.ends)


class Course(TypedDict):
    """The progress of a search: evaluations, E, and its terms."""

    evaluation: int
    value: float
    parts: dict[str, float]


def _course(improvement: Improvement) -> Course:
    return {
        "evaluation": improvement.evaluation,
        "value": float(improvement.value),
        "parts": _plain(improvement.parts),
    }


def _plain(parts: dict[str, float]) -> dict[str, float]:
    return {name: float(value) for name, value in parts.items()}


def _shape(clip: Clip) -> dict[str, object]:
    """Return data of the loaded clip beyond its text: complete keyframes, contacts, grasps and inferred flights."""
    schedule = clip.context.schedule
    return {
        "keys": [
            {"time": key.time, "qpos": key.state.tolist(), "fixed": key.fixed.tolist(), "known": key.known.tolist()}
            for key in clip.authored_keys
        ],
        "stances": [
            {"point": stance.point.name, "from": float(stance.first), "to": float(stance.last)}
            for stance in schedule.stances
        ],
        "flights": [[float(a), float(b)] for a, b in schedule.flights],
        "ends": clip.ends,
        "weights": {penalty.name: float(weight) for penalty, weight in clip.penalties},
    }


def _edited(before: Clip | None, clip: Clip) -> tuple[float, float] | None:
    """Return the interval in which keyframes and contacts differ, up to the next keyframes; None if more differs."""
    if before is None or not before.text or not clip.text or _but_keys(before) != _but_keys(clip):
        return None
    changed = [*_apart(before.keys, clip.keys), *_apart(clip.keys, before.keys), *_moved_contacts(before, clip)]
    if not changed:
        return None
    times = np.array([key.time for key in clip.keys])
    low = int(np.searchsorted(times, min(changed), side="left")) - 1
    high = int(np.searchsorted(times, max(changed), side="right"))
    return float(times[max(low, 0)]), float(times[min(high, times.size - 1)])


def _apart(some: Sequence[Frame], others: Sequence[Frame]) -> list[float]:
    """Return the times of keyframes that are not among others [s]."""
    by_time = {key.time: key for key in others}
    return [key.time for key in some if key.time not in by_time or not _same(key, by_time[key.time])]


def _same(a: Frame, b: Frame) -> bool:
    return np.array_equal(a.fixed, b.fixed) and np.allclose(a.state[a.fixed], b.state[b.fixed], rtol=0, atol=1e-9)


def _but_keys(clip: Clip) -> dict[str, object]:
    table = table_of(clip.text, clip.context.where)
    return table.model_copy(update={"keyframe": [], "contact": []}).model_dump()


def _moved_contacts(before: Clip, clip: Clip) -> list[float]:
    """Return the ends of contacts that only one of two clips has [s]."""
    tables = [table_of(one.text, one.context.where).contact for one in (before, clip)]
    rows = [row for listed, others in (tables, tables[::-1]) for row in listed if row not in others]
    return [time for row in rows for time in (row.start, row.end)]
