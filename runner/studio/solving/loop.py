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
from multiprocessing.connection import Connection
from pathlib import Path
from queue import SimpleQueue
from typing import TYPE_CHECKING, Any

import numpy as np

from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.inbetween import continue_from, inbetween
from dynsplines.solver.one_thread import one_thread
from dynsplines.solver.refine.warm_start import warm_start
from dynsplines.solver.search.minimum import Stop, StopSearch
from dynsplines.solver.search.selection import select_best
from dynsplines.solver.solution import Improvement, Solution

from ... import recordings
from ...clip.build import Clip
from ...clip.parse import table_of
from ...errors import UserError, located, one_line
from ...scene.file_access import allowed
from .. import paths
from ..outline import formats, kinds, outline
from ..solver import Message
from .stage import stage

if TYPE_CHECKING:
    Line = Connection[Any, Any]

MAX_CACHED_PATHS = 40  # number of texts whose paths are cached
SEND_INTERVAL = 0.04  # [s] minimum interval between paths sent


def serve(line: Line, outside: bool) -> None:
    """Run until the other end of the connection is closed. Only the server handles Ctrl-C in the terminal."""
    inbox: SimpleQueue[Message | None] = SimpleQueue()
    loop = SolverLoop(line)
    loop.has_message = lambda: not inbox.empty()
    signal.signal(signal.SIGINT, loop.interrupted)
    threading.Thread(target=_read, args=(line, inbox, loop), daemon=True).start()
    line.send({"is": "kinds", "kinds": kinds()})
    with suppress(BrokenPipeError, EOFError, OSError), allowed(outside), one_thread():
        while (message := inbox.get()) is not None:
            loop.do(message)
    os._exit(0)


def _read(line: Line, inbox: SimpleQueue[Message | None], loop: SolverLoop) -> None:
    """Receive messages; each interrupts a running search."""
    with suppress(EOFError, OSError):
        while True:
            message = line.recv()
            inbox.put(message)
            loop.interrupt()
    inbox.put(None)
    loop.interrupt()


class SolverLoop:
    """A clip, the best path through its keyframes, and the connection to the server."""

    def __init__(self, line: Any) -> None:
        self.line = line
        self.clip: Clip | None = None
        self.solution: Solution | None = None
        self.revision = 0
        self._is_searching = self._is_sending = self._is_interrupted = False
        self._raw_is_pending = self._has_sent_formats = False
        self._sent = 0.0
        self.has_curves = False
        self.path_cache: dict[str, Timeline] = {}
        self.has_message: Callable[[], bool] = lambda: False  # whether a message is waiting
        self._is_going = True
        self._is_cut = False  # whether a message has interrupted the last search
        self._is_restart = False  # whether the last search was a restart

    def do(self, message: Message) -> None:
        """Handle one message; errors are reported to the page."""
        try:
            getattr(self, f"do_{message['do']}")(**{key: value for key, value in message.items() if key != "do"})
        except UserError as error:
            self._report("refused", revision=message.get("revision"), words=one_line(error))
        except Exception as error:  # an internal error, which the page shows before it continues
            self._report("refused", revision=message.get("revision"), words=f"internal error: {located(error)}")
        except KeyboardInterrupt:  # it arrived at the end of a search, after the handler
            self._is_searching, self._is_cut = False, True
        if self._is_cut and self._is_going and not self.has_message():
            self._continue(restart=self._is_restart)  # the message that ended the search did not replace the clip

    def do_load(
        self,
        text: str,
        name: str,
        place: str,
        folder: str,
        revision: int,
        go: bool,
        first: bool,
        initial_path: bytes | None = None,
    ) -> None:
        """Load a text and send its clip and keyframes; then search from the path nearest to the present one.

        Args:
            go: Whether to search.
            first: Whether the text was just opened.
            initial_path: The initial path after a restart of this process, pickled.
        """
        self._is_going = go
        before, solution = self.clip, self.solution
        like = None if first else before
        clip = recordings.from_text(text, name=name, where=place, folder=Path(folder), like=like)
        has_ground = before is not None and clip.figure is before.figure
        self.clip, self.revision, self._is_cut = clip, revision, False
        if not has_ground:
            figure = pickle.dumps((clip.scene, clip.figure.coordinates))
            self._send({"is": "stage", "stage": stage(clip), "figure": figure})
        content = outline(text, place)
        self._report("loaded", revision=revision, notes=list(clip.notes), outline=content, **_shape(clip))
        self._raw_is_pending = True
        path = None if initial_path is None else pickle.loads(initial_path)  # data of this program only
        begin, between = self._initial_guess(clip, before, solution, first=first, initial_path=path)
        if begin is None:
            self._first(clip, go=go)
            return
        self.solution = Solution(clip.figure, clip.problem.objective, begin, clip.problem.raw)
        self._send_path(begin, "initial")
        if go:
            self._search(begin, between)
        else:
            self._judge(stop="paused")

    def _initial_guess(
        self, clip: Clip, before: Clip | None, solution: Solution | None, *, first: bool, initial_path: Timeline | None
    ) -> tuple[Timeline | None, tuple[float, float] | None]:
        """Return the initial guess for a clip, and the edited interval; None if everything is new."""
        cached = self.path_cache.get(clip.text)
        if cached is not None and not first:  # undo or redo
            return cached, None if before is None else _edited(before, clip)
        timeline = initial_path if initial_path is not None else None if solution is None else solution.timeline
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
        """Show a newly opened clip, and search from the raw spline."""
        raw = clip.problem.raw
        self._send_path(raw, "initial")  # a first view
        self.solution = Solution(clip.figure, clip.problem.plain_objective, raw, raw)
        if go:
            self._search(None, None)
        else:
            self._judge(stop="paused")

    def do_go(self, restart: bool = False) -> None:
        """Continue the search from the present path, or restart it from the raw spline."""
        self._is_going = True
        self._continue(restart=restart)

    def _continue(self, *, restart: bool = False) -> None:
        if self.clip is not None and self.solution is not None:
            from_raw = restart or self.solution.timeline is self.solution.raw
            self._search(None if from_raw else self.solution.timeline, None, is_restart=restart)

    def do_stop(self) -> None:
        """Keep the search stopped: the message itself has ended it."""
        self._is_going = False

    def do_curves(self, on: bool) -> None:
        """Switch the curves on or off; computing them takes a moment."""
        self.has_curves = on
        if on:
            self._send_curves()

    def do_save(self, file: str) -> None:
        """Write the present motion to a file for further use."""
        clip, solution = self.clip, self.solution
        if clip is None or solution is None:
            raise UserError("nothing has been solved yet")
        from ... import motion
        from ...solving import Solved
        from ...system.progress import Progress

        saved = Solved(clip, solution, None).saved(Progress(), with_report=False)
        motion.save(saved, Path(file))
        self._report("saved", file=file)

    def interrupt(self) -> None:
        """End the running search, from another thread."""
        if self._is_searching:
            _thread.interrupt_main()

    def interrupted(self, number: int, frame: object) -> None:
        """Handle an interrupt during a search only: it can arrive a moment late."""
        if self._is_sending:
            self._is_interrupted = True
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
        self._is_searching, self._is_interrupted = True, False
        try:
            yield
        except KeyboardInterrupt:
            self._is_searching = False
        finally:
            self._is_searching = False

    def _check_inbox(self) -> None:
        """End a search at its start if a message arrived just before it, because nothing else would interrupt it."""
        if self.has_message():
            raise KeyboardInterrupt

    def _search(self, begin: Timeline | None, between: tuple[float, float] | None, *, is_restart: bool = False) -> None:
        """Minimise E and send every better path. The best path is used, however the search ends.

        A restart sends only paths that are better than the present one, which stays unless the result is better.
        """
        clip, present = self.clip, self.solution
        assert clip is not None
        self._report("searching", revision=self.revision)
        self._is_restart, self._is_cut = is_restart, False
        bound = np.inf
        if is_restart and present is not None:
            bound = clip.problem.objective.value(path_of(present.timeline))

        def improved(improvement: Improvement) -> None:
            if (begin is not None and improvement.evaluation == 1) or improvement.value >= bound:
                return  # a path at least as good is already shown
            if time.monotonic() - self._sent >= SEND_INTERVAL:
                value, parts = float(improvement.value), _plain(improvement.parts)
                timeline, evaluation = improvement.build(), improvement.evaluation
                self._send_path(timeline, "best", evaluation=evaluation, value=value, parts=parts)
                self._send_raw()

        solution = self._minimise(clip, begin, between, improved)
        self._is_cut = solution is None or solution.stop is Stop.INTERRUPTED
        if solution is None:
            self._judge(stop="INTERRUPTED")
            return
        if is_restart:
            self._accept_better(solution)
        else:
            self._accept(solution)
        self._judge(stop=solution.stop.name)

    def _minimise(
        self,
        clip: Clip,
        begin: Timeline | None,
        between: tuple[float, float] | None,
        improved: Callable[[Improvement], None],
    ) -> Solution | None:
        """Return the result of a search, also if a message interrupts it; None if it had no result yet.

        Args:
            begin: The initial guess; None: the raw spline.
            between: The edited interval [s], which is searched before the whole clip.
            improved: Receives every better path.
        """
        best: list[Improvement] = []

        def record(improvement: Improvement) -> None:
            best[:] = [improvement]
            improved(improvement)
            if self._is_interrupted or self.has_message():
                raise StopSearch

        with self._searching():
            self._check_inbox()
            if begin is None:
                return inbetween(clip.problem, improved=record)
            if between is not None:
                first = continue_from(clip.problem, begin, between=(between,), improved=record)
                if first.stop is Stop.INTERRUPTED:
                    return first
                begin = first.timeline
            return continue_from(clip.problem, begin, improved=record)
        if not best:
            return None
        return Solution(clip.figure, clip.problem.objective, best[0].build(), clip.problem.raw, stop=Stop.INTERRUPTED)

    def _accept(self, solution: Solution) -> None:
        clip = self.clip
        assert clip is not None
        self.solution = solution
        self._cache_path(clip.text, solution.timeline)
        cost: Message = {}  # of a path that no search has evaluated
        if solution.trace:
            cost = {"value": solution.trace[-1][2], "parts": _plain(solution.trace[-1][3])}
        self._send_path(solution.timeline, "best", evaluation=solution.evaluations, **cost)

    def _accept_better(self, solution: Solution) -> None:
        """Use the better of the present path and the result of a restart; a note reports which one it is."""
        clip, present = self.clip, self.solution
        assert clip is not None and present is not None
        timelines = [present.timeline, solution.timeline]
        is_better = select_best(clip.problem.objective, timelines) is solution.timeline
        self._accept(solution if is_better else present)
        if solution.stop is not Stop.INTERRUPTED:
            words = f"a better path: E {solution.trace[-1][2]:.3g}" if is_better else "no better path"
            self._report("note", words=f"the restarted search found {words}")

    def _cache_path(self, text: str, timeline: Timeline) -> None:
        """Cache the path of a text, for undo and redo, for the last few texts."""
        self.path_cache.pop(text, None)
        self.path_cache[text] = _bare(timeline)
        if len(self.path_cache) > MAX_CACHED_PATHS:
            del self.path_cache[next(iter(self.path_cache))]

    def _judge(self, stop: str) -> None:
        """Send the present path's violations, and the reason for the end of the search."""
        clip, solution = self.clip, self.solution
        assert clip is not None and solution is not None
        self._send_raw()
        from ...measure.violation import plain, violations

        listed = plain(violations(clip, solution.timeline, solution.raw))
        if not self._has_sent_formats:
            self._has_sent_formats = True
            self._report("formats", **formats())
        frames = solution.timeline.times.tolist()
        self._report("settled", revision=self.revision, stop=stop, violations=listed, frames=frames)
        if self.has_curves:
            self._send_curves()

    def _send_curves(self) -> None:
        if self.clip is not None and self.solution is not None:
            from .curves import curves  # imported late: curves are rarely shown

            self._report("curves", curves=curves(self.clip, self.solution))

    def _send_raw(self) -> None:
        """Send the raw spline, once per text, after more urgent messages."""
        if self._raw_is_pending and self.clip is not None:
            self._raw_is_pending = False
            self._send_path(self.clip.problem.raw, "raw")

    def _send_path(self, timeline: Timeline, stage: str, **details: Any) -> None:
        """Send a path: as the page plays it, and pickled for the server, which adds keyframes from it."""
        clip = self.clip
        assert clip is not None
        self._sent = time.monotonic()
        header = {"is": "path", "kind": stage, "revision": self.revision, **details}
        header["frames"] = [round(float(t), 5) for t in timeline.times]
        data = paths.packed(clip.figure, timeline, header)
        packed = pickle.dumps(_bare(timeline))
        self._send(
            {"is": "path", "kind": stage, "revision": self.revision, "data": data, "timeline": packed, **details}
        )

    def _report(self, what: str, **details: Any) -> None:
        self._send({"is": what, **details})


def _bare(timeline: Timeline) -> Timeline:
    """Return a timeline without caches derived from its times."""
    return Timeline(timeline.frames, timeline.end_slope, timeline.ends)


def _plain(parts: dict[str, float]) -> dict[str, float]:
    return {name: float(value) for name, value in parts.items()}


def _shape(clip: Clip) -> dict[str, object]:
    """Return data of the loaded clip beyond its text: complete keyframes, contacts, grasps and inferred flights."""
    schedule = clip.context.schedule
    return {
        "keys": [
            {"time": key.time, "qpos": key.state.tolist(), "fixed": key.fixed.tolist()} for key in clip.authored_keys
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
    if before is None or not before.text or not clip.text or _without_keys(before) != _without_keys(clip):
        return None
    changed = [
        *_changed_times(before.keys, clip.keys),
        *_changed_times(clip.keys, before.keys),
        *_moved_contacts(before, clip),
    ]
    if not changed:
        return None
    times = np.array([key.time for key in clip.keys])
    low = int(np.searchsorted(times, min(changed), side="left")) - 1
    high = int(np.searchsorted(times, max(changed), side="right"))
    return float(times[max(low, 0)]), float(times[min(high, times.size - 1)])


def _changed_times(keys: Sequence[Frame], others: Sequence[Frame]) -> list[float]:
    """Return the times of keyframes that are not among others [s]."""
    by_time = {key.time: key for key in others}
    return [key.time for key in keys if key.time not in by_time or not _same(key, by_time[key.time])]


def _same(a: Frame, b: Frame) -> bool:
    return np.array_equal(a.fixed, b.fixed) and np.allclose(a.state[a.fixed], b.state[b.fixed], rtol=0, atol=1e-9)


def _without_keys(clip: Clip) -> dict[str, object]:
    table = table_of(clip.text, clip.context.where)
    return table.model_copy(update={"keyframe": [], "contact": []}).model_dump()


def _moved_contacts(before: Clip, clip: Clip) -> list[float]:
    """Return the ends of contacts that only one of two clips has [s]."""
    tables = [table_of(one.text, one.context.where).contact for one in (before, clip)]
    rows = [row for listed, others in (tables, tables[::-1]) for row in listed if row not in others]
    return [time for row in rows for time in (row.start, row.end)]
