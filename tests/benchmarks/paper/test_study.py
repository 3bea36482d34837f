"""The paper's claims are measured to the end, judged by what was measured, and shown."""

from __future__ import annotations

import json
import math
from io import StringIO

import numpy as np
import pytest
from paper import study
from paper.barr import Discrete
from paper.claim import Claim, as_json, table
from paper.study import Case, clip_claims, run
from rich.console import Console

from dynsplines.system.progress import Progress


@pytest.fixture(scope="module")
def claims() -> list[Claim]:
    return run(seeds=1)


def by_text(claims: list[Claim], text: str) -> Claim:
    (found,) = [claim for claim in claims if text in claim.text]
    return found


@pytest.mark.slow
def test_every_claim_has_finite_numbers_for_every_set_and_a_verdict(claims: list[Claim]) -> None:
    assert len(claims) > 20
    for claim in claims:
        assert claim.numbers
        assert all(len(values) == 1 and all(map(math.isfinite, values)) for values in claim.numbers.values())
        assert claim.verdict in ("reproduced", "not reproduced")
        assert claim.verdict == ("reproduced" if claim.reproduced else "not reproduced")
        assert claim.place and claim.text and claim.paper and claim.here and claim.criterion


@pytest.mark.slow
def test_what_holds_for_every_path_is_reproduced(claims: list[Claim]) -> None:
    for text in ("Keyframes are met", "E falls", "as the objective sees it", "10 : 1, 3 variable frames"):
        assert by_text(claims, text).reproduced


@pytest.mark.slow
def test_the_papers_own_weights_are_not_said_to_reach_the_papers_unit_deviation(claims: list[Claim]) -> None:
    claim = by_text(claims, "α_unit : α_cov = 2 : 5")
    assert not claim.reproduced
    assert max(claim.numbers["deviation, 2:5, 1 frame"]) > 0.002


@pytest.mark.slow
def test_the_table_fits_into_80_columns_verdict_first_and_nothing_cut_off(claims: list[Claim]) -> None:
    out = StringIO()
    Console(file=out, width=80).print(table(claims))
    lines = out.getvalue().splitlines()
    assert max(map(len, lines)) <= 80
    assert lines[0] == f"The paper's claims: {sum(claim.reproduced for claim in claims)} of {len(claims)} reproduced"
    assert [line.split("  ")[0] for line in lines[3:] if line[:1].strip()] == [claim.verdict for claim in claims]
    words = " ".join(out.getvalue().split())
    for claim in claims:
        for part in (claim.text, claim.here, claim.criterion, claim.note, claim.paper, claim.place):
            assert " ".join(part.split()) in words
    assert "…" not in words.replace("– ", "")


@pytest.mark.slow
def test_claims_become_json_with_their_verdicts(claims: list[Claim]) -> None:
    entries = json.loads(json.dumps(as_json(claims), allow_nan=False))
    assert [entry["verdict"] for entry in entries] == [claim.verdict for claim in claims]
    assert entries[0]["numbers"] == claims[0].numbers


def test_without_a_set_there_is_nothing_to_measure() -> None:
    with pytest.raises(ValueError, match="seeds = 0"):
        run(seeds=0)


def test_the_work_reports_its_progress(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(study, "STUDIES", study.STUDIES[:1])
    steps: list[tuple[float | None, str]] = []
    progress = Progress(Console(file=StringIO()))
    monkeypatch.setattr(progress, "step", lambda _work, share, note="", **_: steps.append((share, note)))
    assert len(run(2, progress)) == 4
    assert steps == [(0.0, "set 1 of 2: iterates"), (0.5, "set 2 of 2: iterates"), (1.0, "2 sets")]


def test_both_discrete_peers_find_the_same_unit_samples_through_the_keyframes() -> None:
    problem = Discrete(Case(0).track, 5)
    dense, exact = problem.by_slsqp(), problem.by_newton()
    np.testing.assert_allclose(dense, exact, atol=2e-3)
    for x in (dense, exact):
        assert abs(problem.length(x)).max() < 1e-5
        np.testing.assert_array_equal(problem.all_samples(x)[::5], Case(0).track)
    assert problem(exact)[0] == pytest.approx(problem(dense)[0], rel=1e-4)


def test_the_discrete_peers_derivatives_are_exact(rng: np.random.Generator) -> None:
    problem = Discrete(Case(1).track, 3)
    x = problem.start[problem.free].ravel() + 0.05 * rng.normal(size=4 * problem.free.size)
    direction = rng.normal(size=x.size)
    h = 1e-5
    (above, slope_above), (below, slope_below) = problem(x + h * direction), problem(x - h * direction)
    assert (above - below) / (2 * h) == pytest.approx(problem(x)[1] @ direction, rel=1e-7)
    turned = problem.hessian(x) @ direction
    np.testing.assert_allclose((slope_above - slope_below) / (2 * h), turned, rtol=1e-5, atol=1e-5 * abs(turned).max())


@pytest.mark.parametrize(
    ("before", "after", "holds"), [(0.06, 0.0004, True), (0.06, 0.02, False), (0.0002, 0.0, False)]
)
def test_the_claims_about_the_runner_follow_from_the_report(before: float, after: float, holds: bool) -> None:
    report = {
        "clip": "run",
        "seconds": 100.0 * (1 - holds) + 1,
        "evaluations": 7,
        "before": {"penetration, m": {"deepest": before}},
        "after": {"penetration, m": {"deepest": after}},
    }
    for claim in clip_claims(report):
        assert claim.reproduced is holds
        assert "run" in claim.here
