"""The discrete method of Barr, Currin, Gabriel & Hughes (1992) in good faith: the coarsest grid, the fastest solver.

Unknown quaternions at equal steps, covariant acceleration by differences, hard unit length, hard keyframes; exact
derivatives. The grid is the coarsest whose normalised interpolation reaches our energy. Every solver's clock runs until
its iterate, normalised, is within 0.1 % of the value that it ends with, and so does ours.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import nlopt
import numpy as np
from bench import NOT_INSTALLED, REPEATS, Effort, Section, Target, alternated, median, peer
from numpy.typing import NDArray
from paper.barr import Discrete
from rotations import Track, energy, exact_energy, solved, track
from runner39 import noting
from scipy import optimize, sparse

from dynsplines.solver import Improvement, Path, Settings

Array = NDArray[np.float64]
Iterate = tuple[float, Array]

KEYFRAMES = 7
SETS = (5, 2)
WITHIN, REACHED = 1.001, 1.002
LONGEST = 10.0
FEWEST, MOST = 3, 40
OURS = Settings(variable=1, frames=0)
SLOW = ("trust-constr, sparse", "SLSQP of NLopt, dense", "SLSQP of SciPy, dense")


class Watched(Discrete):
    """The discrete problem, recording every point at which a solver evaluates it: (seconds, x)."""

    def __init__(self, orientations: Array, steps: int) -> None:
        super().__init__(orientations, steps)
        self.iterates: list[Iterate] = []
        self.begin = time.perf_counter()

    def __call__(self, x: Array) -> tuple[float, Array]:
        self.iterates.append((time.perf_counter() - self.begin, np.array(x)))
        return super().__call__(x)

    def judged(self, x: Array) -> float:
        """The objective with every sample brought to unit length."""
        q = x.reshape(-1, 4)
        return Discrete.__call__(self, (q / np.linalg.norm(q, axis=1, keepdims=True)).ravel())[0]


constrained: Any = optimize.NonlinearConstraint


def by_trust_constr(problem: Watched) -> Array:
    """SciPy's trust-constr: sparse Jacobian, exact sparse second derivatives."""
    x = problem.start[problem.free].ravel()
    constraint = constrained(
        problem.length,
        0,
        0,
        jac=problem.length_jacobian,
        hess=lambda _x, v: sparse.diags_array(np.repeat(2 * v, 4)),
    )
    options = {"maxiter": 300, "gtol": 1e-5, "xtol": 1e-9}
    result = optimize.minimize(
        problem, x, jac=True, hess=problem.hessian, method="trust-constr", constraints=[constraint], options=options
    )
    return result.x


def by_nlopt(problem: Watched) -> Array:
    """NLopt's SLSQP: dense; on the objective divided by its first value, without which it stays where it starts."""
    x = problem.start[problem.free].ravel()
    optimiser = nlopt.opt(nlopt.LD_SLSQP, x.size)
    unit = problem.judged(x)

    def objective(x: Array, gradient: Array) -> float:
        value, slope = problem(x)
        if gradient.size:
            gradient[:] = slope / unit
        return value / unit

    def length(result: Array, x: Array, jacobian: Array) -> None:
        result[:] = problem.length(x)
        if jacobian.size:
            jacobian[:] = problem.length_jacobian(x).toarray()

    optimiser.set_min_objective(objective)
    optimiser.add_equality_mconstraint(length, np.full(x.size // 4, 1e-6))
    optimiser.set_ftol_rel(1e-5)
    optimiser.set_maxtime(LONGEST)
    return optimiser.optimize(x)


@dataclass(eq=False)
class Ipopt:
    """IPOPT through CasADi with exact Hessian; building the functions is off the clock."""

    casadi: Any
    solver: Any
    start: Array
    bounds: int
    iterates: list[Iterate]
    begin: float
    callback: Any

    @classmethod
    def of(cls, casadi: Any, problem: Discrete) -> Ipopt:
        x = casadi.MX.sym("x", 4 * problem.free.size)
        columns: list[Any] = [casadi.DM(q) for q in problem.start]
        for i, sample in enumerate(problem.free):
            columns[int(sample)] = x[4 * i : 4 * i + 4]
        q = casadi.horzcat(*columns)
        h = problem.h
        a, b, c = (casadi.SX.sym(name, 4) for name in "abc")
        rate = (a - 2 * b + c) / h**2
        w = rate - casadi.dot(rate, b) / casadi.sumsqr(b) * b
        term = casadi.Function("each", [a, b, c], [casadi.sumsqr(w)])
        count = q.shape[1]
        value = h * casadi.sum2(term.map(count - 2)(q[:, : count - 2], q[:, 1 : count - 1], q[:, 2:]))
        lengths = casadi.sum1(casadi.reshape(x, 4, problem.free.size) ** 2).T - 1
        solver = cls(casadi, None, problem.start[problem.free].ravel(), problem.free.size, [], 0.0, None)
        solver.callback = noting(casadi, x.numel(), solver.note, problem.free.size)
        options = {
            "ipopt": {"print_level": 0, "sb": "yes", "tol": 1e-6, "max_iter": 300},
            "print_time": False,
            "iteration_callback": solver.callback,
        }
        solver.solver = casadi.nlpsol("solve", "ipopt", {"x": x, "f": value, "g": lengths}, options)
        return solver

    def note(self, x: Array) -> None:
        self.iterates.append((time.perf_counter() - self.begin, x))

    def run(self) -> list[Iterate]:
        self.iterates, self.begin = [], time.perf_counter()
        result = self.solver(x0=self.start, lbg=0, ubg=0)
        return [*self.iterates, (time.perf_counter() - self.begin, np.array(result["x"]).ravel())]


def watched(solve: Callable[[Any], Array], orientations: Array, steps: int) -> list[Iterate]:
    """A solver's points, its end last; setting up the problem is off the clock."""
    problem = Watched(orientations, steps)
    problem.begin = time.perf_counter()
    solution = solve(problem)
    return [*problem.iterates, (time.perf_counter() - problem.begin, np.array(solution))]


def ours(track: Track) -> tuple[list[tuple[float, Path]], Path]:
    """Our improvements, the verb's end last."""
    iterates: list[tuple[float, Path]] = []
    begin = time.perf_counter()

    def improved(step: Improvement) -> None:
        iterates.append((time.perf_counter() - begin, step.path))

    motion = solved(track, OURS, improved)
    iterates.append((time.perf_counter() - begin, motion.path))
    return iterates, motion.path


def arrival(times: list[float], values: list[float]) -> float:
    """When a value is first within 0.1 % of the last one, and stays at most there at the end."""
    return next(t for t, value in zip(times, values, strict=True) if value <= WITHIN * values[-1])


def coarsest(track: Track, goal: float) -> int:
    """The fewest steps a segment whose normalised interpolation reaches an energy."""
    for steps in range(FEWEST, MOST):
        problem = Discrete(track.orientations, steps)
        if energy(problem.path(problem.by_newton())) <= goal:
            return steps
    return MOST


def of_set(track: Track, effort: Effort) -> dict[str, Any]:
    """Clocks [s] of every solver on one set."""
    effort.report(f"{track.name}: the coarsest grid")
    goal = energy(ours(track)[1])
    steps = coarsest(track, goal)
    grid = Discrete(track.orientations, steps)
    track_of = track.orientations
    works: dict[str, Callable[[], Any]] = {"ours": lambda: ours(track)}
    works["sparse Newton SQP"] = lambda: watched(Discrete.by_newton, track_of, steps)
    row: dict[str, Any] = {"set": track.name, "steps": steps, "exact": exact_energy(track), "ours": goal}
    casadi = peer("casadi")
    if casadi is not None:
        begin = time.perf_counter()
        ipopt = Ipopt.of(casadi, grid)
        row["IPOPT, building [s]"] = time.perf_counter() - begin
        works["IPOPT, exact Hessian"] = ipopt.run
    slow = {"trust-constr, sparse": by_trust_constr, "SLSQP of NLopt, dense": by_nlopt}
    for name, solve in ({"SLSQP of SciPy, dense": Discrete.by_slsqp} | slow).items():
        works[name] = lambda solve=solve: watched(solve, track_of, steps)
    clocks: dict[str, list[float]] = {name: [] for name in works}
    totals: dict[str, list[float]] = {name: [] for name in works}
    judge = Watched(track_of, steps)
    failed: dict[str, str] = {}

    def measured(name: str) -> None:
        if name in failed:
            return
        effort.report(f"{track.name}, {steps} steps a segment: {name}")
        try:
            got = works[name]()
        except (ValueError, RuntimeError, ArithmeticError, nlopt.RoundoffLimited) as error:
            failed[name] = type(error).__name__
            return
        if name == "ours":
            iterates, path = got
            values, reached = [energy(p) for _, p in iterates], energy(path)
        else:
            iterates = got
            values, reached = [judge.judged(x) for _, x in iterates], energy(grid.path(iterates[-1][1]))
        if reached > REACHED * goal:
            failed[name] = f"energy {reached / goal:.4f} × ours after {iterates[-1][0]:.1f} s"
            return
        row[f"{name}, energy"] = reached
        clocks[name].append(arrival([t for t, _ in iterates], values))
        totals[name].append(iterates[-1][0])

    fast = [name for name in works if name not in SLOW]
    for name in fast:
        works[name]()
    alternated({name: lambda name=name: measured(name) for name in fast}, effort.repeats, warm=False)
    both = ["ours", *(name for name in works if name in SLOW)]
    alternated({name: lambda name=name: measured(name) for name in both}, effort.count(REPEATS, 1), warm=False)
    row["clock [s]"] = {name: median(clock_values) for name, clock_values in clocks.items() if clock_values}
    row["total [s]"] = {name: median(clock_values) for name, clock_values in totals.items() if clock_values}
    row["failed"] = failed
    return row


def measure(effort: Effort) -> Section:
    section = Section(
        "The discrete method of Barr et al. 1992 on its coarsest grid that reaches our energy; seven orientations",
        ("solver", "to 0.1 % of its end [ms]", "× ours", "whole [ms]", "energy / exact", "steps a segment", "failed"),
    )
    rows = [of_set(track("moderate", seed, KEYFRAMES), effort) for seed in range(effort.count(*SETS))]
    grid = f"{min(row['steps'] for row in rows)}–{max(row['steps'] for row in rows)}"
    names = list(dict.fromkeys(name for row in rows for name in [*row["clock [s]"], *row["failed"]]))
    failures = [f"{row['set']}, {name}: {why}" for row in rows for name, why in row["failed"].items()]
    times: dict[str, float] = {}
    for name in names:
        done = [row for row in rows if name in row["clock [s]"]]
        if done:
            times[name] = median([row["clock [s]"][name] / row["clock [s]"]["ours"] for row in done])
        section.add(
            name,
            1e3 * median([row["clock [s]"][name] for row in done]),
            times.get(name),
            1e3 * median([row["total [s]"][name] for row in done]),
            f"{median([row[f'{name}, energy'] / row['exact'] for row in done if row['exact']]):.6f}" if done else "–",
            "–" if name == "ours" else grid,
            f"{sum(name in row['failed'] for row in rows)} of {len(rows)}",
        )
    if "IPOPT, exact Hessian" not in names:
        section.add("IPOPT, exact Hessian", NOT_INSTALLED, *["–"] * 5)
    fastest = min((name for name in times if name != "ours"), key=lambda name: times[name])
    dense = min((name for name in SLOW if "dense" in name and name in times), key=lambda name: times[name], default="")
    section.targets = [
        Target(f"fastest of all ({fastest}) / ours", times[fastest], 100.0, least=True),
        Target(f"fastest dense SQP, as in 1992 ({dense}) / ours", times.get(dense), 100.0, least=True),
    ]
    section.notes = [
        f"{len(rows)} moderate sets (steps of 20-90°, 1 s apart), seeds from 0; ours: one variable frame a segment, "
        "all of `inbetween` on the clock",
        "theirs: unknown quaternions at equal steps, exact derivatives, hard unit length and keyframes, from the "
        "normalised natural spline; the coarsest grid is found with Newton steps; that and setting up: off the clock",
        "iterates are brought to unit length before they are judged, by the solver's own sum; trial points count; "
        "trust-constr and IPOPT use exact sparse second derivatives",
        f"failed: raises, or ends over {REACHED} × our energy: {'; '.join(failures) or 'none'}",
    ]
    section.data = {"sets": rows}
    return section
