"""Progress: a bar where there is a terminal, plain lines elsewhere, and nothing on stdout."""

from __future__ import annotations

import io

import pytest
from rich.console import Console

from dynsplines.system import progress
from dynsplines.system.progress import Progress


@pytest.fixture
def out() -> io.StringIO:
    return io.StringIO()


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    now = [100.0]
    monkeypatch.setattr(progress.time, "monotonic", lambda: now[0])
    return now


def test_without_a_terminal_progress_is_plain_lines(out, clock):
    with Progress(Console(file=out)) as teller:
        teller.step("solving", 0.25, "E 2.4")
        clock[0] += 10
        teller.step("solving", None, "E 2.3")
    assert out.getvalue() == "solving  25% E 2.4\nsolving E 2.3\n"


def test_lines_come_no_faster_than_anybody_reads_them_but_for_the_last(out, clock):
    with Progress(Console(file=out)) as teller:
        for i in range(100):
            clock[0] += 0.1
            teller.step("solving", None, str(i))
        teller.step("solving", 1.0, "end", force=True)
    lines = out.getvalue().splitlines()
    assert len(lines) == 3
    assert lines[-1] == "solving 100% end"


def test_items_come_through_untouched_and_counted(out, clock):
    with Progress(Console(file=out)) as teller:
        assert list(teller.over(iter("abc"), "rendering", 3)) == ["a", "b", "c"]
    assert out.getvalue().splitlines() == ["rendering  33% 1 of 3", "rendering 100% 3 of 3"]


def test_an_item_is_reported_only_once_it_has_been_used(out, clock):
    items = Progress(Console(file=out)).over(iter("ab"), "rendering", 2)
    next(items)
    assert out.getvalue() == ""
    next(items)
    assert out.getvalue() == "rendering  50% 1 of 2\n"


def test_long_lines_are_not_broken_and_brackets_are_no_markup(out):
    line = "note: [red]" + "words " * 40 + "[/red] end"
    Progress(Console(file=out, width=40)).report(line)
    assert out.getvalue() == line + "\n"


def test_on_a_terminal_there_is_a_bar(out):
    with Progress(Console(file=out, force_terminal=True, width=100)) as teller:
        teller.step("solving", 0.5, "E 2.4")
        teller.step("solving", 1.0, "E 2.0")
        teller.step("counting", None, "x")
        teller.report("a line that stays")
    shown = out.getvalue()
    assert "solving" in shown
    assert "E 2.0" in shown
    assert "a line that stays" in shown
    assert "\x1b[" in shown


def test_progress_goes_to_stderr(capsys):
    Progress().report("hello")
    assert capsys.readouterr() == ("", "hello\n")
