"""A clip is loaded stage by stage: few files are entered, and few of them again after they were left."""

from __future__ import annotations

import sys
from pathlib import Path
from types import FrameType

from dynsplines.clip.load import load

RUNNER = str(Path(load.__code__.co_filename).parents[1])
MOST_FILES, MOST_RETURNS = 22, 18  # [1] limits of one load, above the present 21 and 16


class Trace:
    """The files of the runner in the order in which they are entered, and the returns to files that were left.

    A return is a pair of files: the caller's, and the one that it enters again. A line of the caller that enters the
    same file several times, as in a loop, counts only if the file was left before its first call.
    """

    def __init__(self) -> None:
        self.files: list[str] = []
        self.returns: set[tuple[str, str]] = set()
        self._stack: list[str] = []
        self._left: set[str] = set()
        self._calls: set[tuple[str, int, str]] = set()

    def __call__(self, frame: FrameType, event: str, _: object) -> None:
        file = frame.f_code.co_filename
        if not file.startswith(RUNNER):
            return
        if event == "return" and self._stack:
            last = self._stack.pop()
            self._left |= {last} - {*self._stack}
        if event == "call":
            caller, line = self._caller(frame)
            if file not in self.files:
                self.files.append(file)
            elif file in self._left and file not in self._stack and (caller, line, file) not in self._calls:
                self.returns.add((caller, file))
            self._calls.add((caller, line, file))
            self._stack.append(file)

    @staticmethod
    def _caller(frame: FrameType) -> tuple[str, int]:
        above = frame.f_back
        while above is not None and not above.f_code.co_filename.startswith(RUNNER):
            above = above.f_back
        return ("", 0) if above is None else (above.f_code.co_filename, above.f_lineno)


def test_a_clip_loads_through_few_files_and_returns_to_few_of_them():
    load("tumble")  # fills caches
    trace = Trace()
    sys.setprofile(trace)
    try:
        load("walk_and_turn")
    finally:
        sys.setprofile(None)
    names = [str(Path(file).relative_to(RUNNER).with_suffix("")) for file in trace.files]
    assert len(names) <= MOST_FILES, names
    assert len(trace.returns) <= MOST_RETURNS, sorted(trace.returns)
    stages = ["clip/parse", "clip/pose", "clip/build"]
    assert [name for name in names if name in stages] == stages
