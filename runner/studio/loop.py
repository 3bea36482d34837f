"""The loop of the solver process: a text in; its keyframes, every better path and its violations out.

A message during a search interrupts it. It continues from the best path so far, unless the message replaces the clip.
"""

from __future__ import annotations

import _thread
import os
import pickle
import signal
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path
from queue import SimpleQueue
from typing import TYPE_CHECKING, Any

import numpy as np

from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.inbetween import ROUGH, continue_from, inbetween, one_thread
from dynsplines.solver.problem import Improvement, Solution
from dynsplines.solver.refine.warm_start import warm_start
from dynsplines.solver.search.minimum import Stop, StopSearch

from .. import recordings
from ..clip.build import Clip
from ..clip.half_cycle import MIRRORED
from ..clip.parse import table_of
from ..errors import UserError, locate, one_line
from ..scene.file_access import allow
from . import paths
from .curves import curves, overshoots
from .solver import Message, release_memory
from .stage import kinds, outline, stage

if TYPE_CHECKING:
    Line = Connection[Any, Any]

MAX_CACHED = 40  # number of texts whose solutions are cached
SEND_INTERVAL = 0.04  # [s] minimum interval between paths sent


def serve(line: Line, outside: bool) -> None:
    """Run until the other end of the connection is closed. Only the server handles Ctrl-C in the terminal."""
    inbox: SimpleQueue[Message | None] = SimpleQueue()
    outbox: SimpleQueue[Message] = SimpleQueue()
    loop = SolverLoop(outbox.put, lambda: not inbox.empty())
    signal.signal(signal.SIGINT, loop.handle_interrupt)
    threading.Thread(target=_read, args=(line, inbox, loop), daemon=True).start()
    threading.Thread(target=_write, args=(line, outbox), daemon=True).start()
    outbox.put({"is": "kinds", "kinds": kinds()})
    with allow(outside), one_thread():
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


def _write(line: Line, outbox: SimpleQueue[Message]) -> None:
    """Send messages in a separate thread, where no interrupt can cut one short."""
    with suppress(OSError):
        while True:
            line.send(outbox.get())


class SolverLoop:
    """A clip, and a path through its keyframes.

    After an edit, a search from the present path soon shows a good one. A search from the raw spline follows. Its
    result, which depends on the text alone, is that of `dynsplines solve`.

    Args:
        send: Sends a message to the server.
        has_message: Returns whether a message is waiting.

    Attributes:
        is_searching: Whether a search runs as long as no message waits.
        is_near: Whether the present path is near a minimum, so that the search from the raw spline comes next.
    """

    def __init__(self, send: Callable[[Message], None], has_message: Callable[[], bool]) -> None:
        self.send, self.has_message = send, has_message
        self.clip: Clip | None = None
        self.solution: Solution | None = None
        self.is_searching = self.is_near = False
        self.revision = 0
        self.has_curves = False
        self.cache: dict[str, Any] = {}  # by text, results of searches from the raw spline, without figures
        self._is_interruptible = False
        self._sent = 0.0  # [s] when the last path was sent

    def do(self, message: Message) -> None:
        """Perform a request, then search until a message waits or the search ends. Errors are reported to the page."""
        arguments = {key: value for key, value in message.items() if key != "do"}
        self._try(getattr(self, f"do_{message['do']}"), message.get("id"), **arguments)
        while self.is_searching and not self.has_message():
            if not self._try(self._run, None):
                self.is_searching = False

    def _try(self, step: Callable[..., None], number: int | None, **arguments: Any) -> bool:
        """Return whether a step has ended without an error, which is reported as the answer to a request."""
        try:
            step(**arguments)
        except KeyboardInterrupt:  # it arrived just outside of a search, which continues
            self._is_interruptible = False
        except UserError as error:
            self._report("refused", id=number, words=one_line(error))
            return False
        except Exception as error:  # an internal error, which the page shows before it continues
            self._report("refused", id=number, words=f"internal error: {locate(error)}")
            return False
        return True

    def do_load(
        self,
        text: str,
        name: str,
        place: str,
        folder: str,
        revision: int,
        go: bool,
        id: int | None = None,
    ) -> None:
        """Load a text and send its clip and keyframes. With `go`, a search starts from the present path."""
        before = self.clip
        if table_of(text, place).solve.ends == MIRRORED:
            raise UserError(
                f"{place}: the studio edits whole cycles; write one: dynsplines mirror {place} --append -o NEW.toml"
            )
        clip = recordings.from_text(text, name=name, where=place, folder=Path(folder), like=before)
        is_same = before is not None and before.name == name
        present = self.solution.timeline if is_same and self.solution is not None else None
        known, cached = None, self.cache.get(clip.text)  # of a clip that was undone or redone
        if cached is not None and np.array_equal(cached[1].rows, clip.problem.raw.rows):  # no files have changed
            known = Solution(clip.figure, clip.problem.objective, *cached)
        begin = self._initial_guess(clip, before, present) if known is None else known.timeline
        if before is None or clip.figure is not before.figure:
            figure = pickle.dumps(clip.scene)
            self.send({"is": "stage", "stage": stage(clip), "figure": figure})
        self._report(
            "loaded", id=id, revision=revision, notes=list(clip.notes), outline=outline(text, place),
            timeline=pickle.dumps(_bare(begin or clip.problem.raw)), **_shape(clip),
        )  # fmt: skip
        self.clip, self.revision = clip, revision
        self._begin(clip, begin)
        self._send_path(clip.problem.raw, "raw")
        self.is_searching = go and known is None
        if known is not None:
            self._show(known)
            self._judge(known.stop.name)
        elif not go:
            self._judge("paused")

    def _initial_guess(self, clip: Clip, before: Clip | None, present: Timeline | None) -> Timeline | None:
        """Return the initial guess for a clip from the present path; None if that does not fit."""
        if present is None or clip.has_recording or present.width != clip.figure.width or present.ends != clip.ends:
            return None
        travel = None if clip.problem.travel is None else np.asarray(clip.problem.travel, float)
        keys = clip.keys if before is None else before.keys
        try:
            return warm_start(clip.figure, present, keys, clip.keys, clip.problem.raw, travel, clip.problem.turn)
        except ValueError:
            return None

    def _begin(self, clip: Clip, begin: Timeline | None) -> None:
        """Make the initial guess of a search, or the raw spline if it is None, the present path."""
        problem = clip.problem
        objective = problem.plain_objective if begin is None else problem.objective
        self.solution = Solution(clip.figure, objective, begin or problem.raw, problem.raw)
        self.is_near = begin is None
        self._send_path(self.solution.timeline, "initial")
        self._send_curves()

    def do_go(self) -> None:
        """Continue the search."""
        self.is_searching = self.clip is not None

    def do_stop(self) -> None:
        """Stop the search, which the message itself has interrupted."""
        if self.is_searching:
            self.is_searching = False
            self._judge(Stop.INTERRUPTED.name)

    def do_curves(self, on: bool) -> None:
        """Switch the curves on or off; computing them takes a moment."""
        self.has_curves = on
        self._send_curves()

    def do_save(self, file: str, id: int | None = None) -> None:
        """Write the present motion to a file for further use."""
        if self.clip is None or self.solution is None:
            raise UserError("nothing has been solved yet")
        from .. import motion
        from ..solving import motion_of

        motion.save(motion_of(self.clip, self.solution), Path(file))
        self._report("saved", id=id)

    def interrupt(self) -> None:
        """End the running search, from another thread."""
        if self._is_interruptible:
            _thread.interrupt_main()

    def handle_interrupt(self, number: int, frame: object) -> None:
        """Handle an interrupt during a search only: it can arrive a moment late."""
        if self._is_interruptible:
            raise KeyboardInterrupt

    def _run(self) -> None:
        """Run the next search and send better paths. If a message ends it, it continues or is repeated afterwards."""
        clip, present = self.clip, self.solution
        assert clip is not None and present is not None
        self._report("searching", revision=self.revision)
        if self.is_near:  # the first result of an edit does not wait for it
            release_memory()
        is_warm, is_first, last = not self.is_near, present.timeline is present.raw, np.inf

        def improved(improvement: Improvement) -> None:
            nonlocal last
            is_better = improvement.evaluation > 1 if is_warm else is_first
            if is_better and time.monotonic() - self._sent >= SEND_INTERVAL:
                self._send_path(improvement.build(), "best", **_cost(improvement.value, improvement.parts))
            if self.has_message() or (is_warm and improvement.value > (1 - ROUGH) * last):
                raise StopSearch
            last = improvement.value

        solution = self._minimise(clip, present.timeline if is_warm else None, improved)
        if solution is None:
            return
        is_result = not is_warm and solution.stop is not Stop.INTERRUPTED
        self.is_near = self.is_near or not self.has_message()
        if is_warm or is_first or is_result:
            self._show(solution)
        if is_result:
            timelines = _bare(solution.timeline), _bare(solution.raw)
            self.cache[clip.text] = (*timelines, solution.trace[-1:], solution.evaluations, solution.stop)
            if len(self.cache) > MAX_CACHED:
                del self.cache[next(iter(self.cache))]
            self.is_searching = False
            self._judge(solution.stop.name)

    def _show(self, solution: Solution) -> None:
        """Make the path of a solution the present one, and send it."""
        self.solution = solution
        self._send_path(solution.timeline, "best", **(_cost(*solution.trace[-1][2:]) if solution.trace else {}))

    def _minimise(self, clip: Clip, begin: Timeline | None, improved: Callable[[Improvement], None]) -> Solution | None:
        """Return the result of a search, from the raw spline if `begin` is None. Return None if a message has ended it
        outside of the solver."""
        try:
            self._is_interruptible = True
            if self.has_message():  # it arrived just before, so that nothing else would interrupt the search
                return None
            if begin is None:
                return inbetween(clip.problem, improved=improved)
            return continue_from(clip.problem, begin, improved=improved)
        except KeyboardInterrupt:
            return None
        finally:
            self._is_interruptible = False

    def _judge(self, stop: str) -> None:
        """Send the present path's violations, and the reason for the end of the search."""
        clip, solution = self.clip, self.solution
        assert clip is not None and solution is not None
        from ..measure.measurement import Measurement  # imported late: the figure is already shown
        from ..measure.violation import plain, violations_of

        listed = plain(violations_of(Measurement.of(clip, solution.timeline, solution.raw)))
        frames = solution.timeline.times.tolist()
        marks = overshoots(clip.figure, clip.authored_keys, solution.timeline)
        self._report("settled", revision=self.revision, stop=stop, violations=listed, frames=frames, overshoots=marks)
        self._send_curves()
        release_memory()

    def _send_curves(self) -> None:
        if self.has_curves and self.clip is not None and self.solution is not None:
            self._report("curves", curves=curves(self.clip.figure, self.solution))

    def _send_path(self, timeline: Timeline, kind: str, **details: Any) -> None:
        """Send a path: as the page plays it, and pickled for the server, which adds keyframes from it."""
        assert self.clip is not None
        self._sent = time.monotonic()
        header = {"is": "path", "kind": kind, "revision": self.revision, **details}
        frames = [round(float(t), 5) for t in timeline.times]
        key_times = [key.time for key in self.clip.authored_keys]
        data = paths.pack(self.clip.figure, timeline, {**header, "frames": frames}, key_times)
        self.send({**header, "data": data, "timeline": pickle.dumps(_bare(timeline))})

    def _report(self, what: str, **details: Any) -> None:
        self.send({"is": what, **details})


def _bare(timeline: Timeline) -> Timeline:
    """Return a timeline without caches derived from its times."""
    return Timeline(timeline.frames, timeline.end_slope, timeline.ends)


def _cost(value: float, parts: dict[str, float]) -> Message:
    """Return E and its terms, with numbers of Python."""
    return {"value": float(value), "parts": {name: float(part) for name, part in parts.items()}}


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
        "weights": {penalty.name: float(weight) for penalty, weight in clip.penalties},
    }
