"""Progress: a bar where there is a terminal, plain lines elsewhere, and nothing on stdout."""

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


def test_without_a_terminal_progress_is_few_plain_lines_with_the_last(out, clock):
    with Progress(Console(file=out)) as progress_bar:
        progress_bar.step("solving", 0.25, "E 2.4")
        for i in range(100):
            clock[0] += 0.1
            progress_bar.step("solving", None, str(i))
        progress_bar.step("solving", 1.0, "end", force=True)
    lines = out.getvalue().splitlines()
    assert (lines[0], lines[-1], len(lines)) == ("solving  25% E 2.4", "solving 100% end", 3)


def test_items_come_through_and_are_counted_once_they_have_been_used(out, clock):
    items = Progress(Console(file=out)).over(iter("ab"), "rendering", 2)
    assert next(items) == "a" and out.getvalue() == ""
    assert list(items) == ["b"]
    assert out.getvalue().splitlines() == ["rendering  50% 1 of 2", "rendering 100% 2 of 2"]


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
