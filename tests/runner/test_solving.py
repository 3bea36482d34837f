"""The main job: solving is told as it goes, and whatever stops it, the best path is kept."""

import io

import pytest
from problems import CLIP, changed, written
from rich.console import Console

from dynsplines import recordings, solving
from dynsplines.clip.build import Clip
from dynsplines.edit.thinning import thin_motion
from dynsplines.solver.search.minimum import Stop
from dynsplines.system.progress import Progress


@pytest.fixture
def problem(tmp_path) -> Clip:
    return recordings.load(str(written(tmp_path, changed("evaluations = 8", "evaluations = 40"))))


class Listening(Progress):
    """Keeps every step, and can press Ctrl-C at one."""

    def __init__(self, interrupt_at: int = 0) -> None:
        self.out = io.StringIO()
        super().__init__(Console(file=self.out))
        self.steps: list[str] = []
        self.interrupt_at = interrupt_at

    def step(self, work: str, share: float | None, note: str = "", *, force: bool = False) -> None:
        self.steps.append(note)
        if len(self.steps) == self.interrupt_at:
            raise KeyboardInterrupt


def test_every_improvement_is_reported_and_the_last_line_sums_up(problem):
    progress = Listening()
    solved = solving.solve(problem, progress)
    assert len(progress.steps) == len(solved.trace) + 1
    assert "->" in progress.steps[-1]
    assert solved.search["seconds"] > 0
    values = [entry[2] for entry in solved.trace]
    assert values == sorted(values, reverse=True)
    assert values[-1] < 0.9 * values[0]


def test_what_was_not_found_is_reported_first(tmp_path):
    figure = recordings.load(str(written(tmp_path, CLIP)))
    assert figure.notes == ()
    text = (tmp_path / "tiny.xml").read_text(encoding="utf-8").replace("left_toe", "tip")
    (tmp_path / "tiny.xml").write_text(text, encoding="utf-8")
    progress = Listening()
    solving.solve(recordings.load(str(tmp_path / "tiny.toml")), progress)
    assert progress.out.getvalue().splitlines() == [
        "note: no feet found, nor a site named heel or toe: no contact points"
    ]
    rows = "".join(f"[[keyframe]]\ntime = {time}\njoints.swing = 0\n" for time in (0, 1))
    hinges = recordings.load(str(written(tmp_path, f'figure = "hinge.xml"\n{rows}', "swing.toml")))
    assert not [note for note in hinges.notes if "limits on bending" in note]


def test_an_interrupted_solve_keeps_the_best_path(problem):
    progress = Listening(interrupt_at=4)
    solved = solving.solve(problem, progress)
    assert solved.stop is Stop.INTERRUPTED
    assert len(solved.trace) == 4
    assert "the best path so far is kept" in progress.out.getvalue()
    value = problem.problem.objective.value(solved.path)
    assert value == pytest.approx(solved.trace[-1][2], rel=1e-9)
    assert value < problem.problem.objective.value(solving.raw_spline(problem).path)


def test_nothing_is_computed_from_the_best_path_of_an_interrupted_search(tmp_path, monkeypatch):
    """A clip that follows another, and a motion that is thinned with --solve."""
    written(tmp_path)
    follower = written(tmp_path, 'figure = "tiny.xml"\n[recording]\nfile = "tiny.toml"\n', "follower.toml")
    saved = solving.solve(recordings.load(str(tmp_path / "tiny.toml")), Listening())
    solve = solving.solve
    monkeypatch.setattr(solving, "solve", lambda clip, _: solve(clip, Listening(interrupt_at=2)))
    with pytest.raises(KeyboardInterrupt):
        recordings.load(str(follower))
    with pytest.raises(KeyboardInterrupt):
        thin_motion(saved, 0.001, 0.01, solve=True)


def test_unsolved_is_the_raw_spline_through_the_keyframes(problem):
    solved = solving.raw_spline(problem)
    assert solved.timeline is solved.raw
    assert solved.report == solved.search == {}
    assert solved.timeline.times.tolist() == [0, 0.2, 0.41]
