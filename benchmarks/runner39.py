"""The 39-DOF runner: time until each method's path is within 0.5 % of the optimum, on the same unknowns and samples.

`runner39.json` holds six running poses of the shipped clip run_and_step (its keyframes at 0 … 0.63 s, rounded to 1e-6),
re-timed evenly over 2 s: stretched so, the raw spline drives the feet 31 mm into the floor. Objective: ∫ root
acceleration² + ∫ Σ |ω'|² over the 12 bodies + 1e7 ∫ depth² of heels and toes below z = 0, and a small gauge for the
quaternions' length.
"""

from __future__ import annotations

import contextlib
import importlib
import json
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path as File
from typing import Any

import mujoco
import numpy as np
from bench import NOT_INSTALLED, Effort, Section, Target, alternated, median, peer
from numpy.typing import NDArray
from paper.nearest import optimise

from dynsplines import models
from dynsplines.solver import (
    Figure,
    Frame,
    Improvement,
    Objective,
    Path,
    Problem,
    Quadrature,
    Settings,
    Timeline,
    inbetween,
)
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import Spline
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Collision, CovariantAcceleration, RootAcceleration, UnitMagnitude
from dynsplines.solver.refine.subdivision import split
from dynsplines.solver.surface import Plane
from dynsplines.solver.surface.points import site_points

Array = NDArray[np.float64]

VARIABLE, FINEST = 3, 15
REFINED = (FINEST - VARIABLE) // (VARIABLE + 1)  # frames between two frames of a solution, for as fine a one
SAMPLES, JUDGED = 101, 2001
DEPTH_WEIGHT, GAUGE = 1e7, 10.0
WITHIN = 1.005
SOLES = ("left_heel", "left_toe", "right_heel", "right_toe")
CHUNK = 16
CASADI_ITERATIONS, MUJOCO_ITERATIONS = 400, 30

Iterate = tuple[float, Path]


@dataclass(frozen=True, eq=False)
class Runner:
    """The problem, and the value by which every method's iterates are judged."""

    figure: Figure
    keys: tuple[Frame, ...]

    @classmethod
    def load(cls) -> Runner:
        data = json.loads((File(__file__).parent / "runner39.json").read_text(encoding="utf-8"))
        figure = Figure(mujoco.MjModel.from_xml_string(models.figure_text("human")))
        rows = zip(data["time"], data["qpos"], strict=True)
        return cls(figure, tuple(Frame.key(t, np.array(qpos)) for t, qpos in rows))

    @cached_property
    def contact(self) -> Collision:
        floor = Plane("floor", np.zeros(3), np.array([0.0, 0.0, 1.0]))
        return Collision(site_points(self.figure, SOLES), (floor,))

    @property
    def penalties(self) -> tuple[tuple[Any, float], ...]:
        """∫ |ω'|² = 4 ∫ f₂*, so the covariant term weighs 4."""
        pure = ((RootAcceleration(), 1.0), (CovariantAcceleration(), 4.0), (self.contact, DEPTH_WEIGHT))
        return (*pure, (UnitMagnitude(), GAUGE))

    @cached_property
    def judge(self) -> Objective:
        """Without the gauge: what is left does not depend on the quaternions' length."""
        return Objective.of(self.figure, self.penalties[:3], quadrature=Quadrature("uniform", JUDGED))

    def value(self, path: Path) -> float:
        """The objective on 2001 samples."""
        return self.judge.value(path)

    def value_on_samples(self, path: Path) -> float:
        """The objective on the 101 samples that the methods saw."""
        sampled = Objective.of(self.figure, self.penalties[:3], quadrature=Quadrature("uniform", SAMPLES))
        return sampled.value(path)

    def settings(self, variable: int) -> Settings:
        return Settings(
            variable=variable,
            frames=variable * (len(self.keys) - 1),
            renormalise=False,
            quadrature=Quadrature("uniform", SAMPLES),
            tolerance=1e-7,
            max_evaluations=2000,
        )

    @cached_property
    def timeline(self) -> Timeline:
        """Three variable frames a segment on the raw spline: where every method starts."""
        return _split_evenly(raw_timeline(self.figure, list(self.keys)), VARIABLE)


class Unknowns:
    """The unknowns of all programs: rows of variable frames and of the two end slopes, flat; x = 0 is no start.

    bases  three dense matrices (S, M + 2): states and their derivatives at the samples from the rows
    """

    def __init__(self, runner: Runner) -> None:
        timeline = runner.timeline
        self.path = Path(Spline(timeline.times), np.asarray(timeline.rows))
        self.free = np.array([i for i, f in enumerate(timeline.frames) if f.is_variable] + [-2, -1])
        t, weights = Quadrature("uniform", SAMPLES).nodes(timeline.times)
        self.weights = weights
        spline = self.path.spline
        eye = spline.coefficients(np.eye(spline.size))
        self.bases = np.array([spline.basis(t, order) @ eye for order in range(3)])
        self.start = self.path.rows[self.free].ravel()
        fixed = self.path.rows.copy()
        fixed[self.free] = 0
        self.constant = self.bases @ fixed
        self.moving = np.ascontiguousarray(self.bases[:, :, self.free])

    def path_of(self, x: Array) -> Path:
        rows = self.path.rows.copy()
        rows[self.free] = np.reshape(x, (self.free.size, -1))
        return Path(self.path.spline, rows)

    def states(self, columns: Array) -> Array:
        """y, y', y'' (3, k, S, N) of x (n, k)."""
        rows = columns.T.reshape(columns.shape[1], self.free.size, -1)
        return self.constant[:, None] + np.matmul(self.moving[:, None], rows[None])


def ours(runner: Runner) -> list[Iterate]:
    """The public verb, everything but loading the figure on the clock."""
    iterates: list[Iterate] = []
    begin = time.perf_counter()

    def improved(step: Improvement) -> None:
        iterates.append((time.perf_counter() - begin, step.path))

    inbetween(Problem(runner.figure, runner.keys, runner.penalties, runner.settings(VARIABLE)), improved=improved)
    return [*iterates, (time.perf_counter() - begin, iterates[-1][1])]


class LeastSquares:
    """The objective as residuals (55 a sample), for `mujoco.minimize.least_squares`."""

    def __init__(self, runner: Runner, unknowns: Unknowns) -> None:
        self.runner, self.unknowns = runner, unknowns
        self.figure = runner.figure
        self.root = np.sqrt(2 * unknowns.weights[0])

    def of_states(self, states: Array) -> Array:
        """(R, T) residuals at T states, (3, T, N)."""
        samples = Samples(self.figure, *states)
        alpha = samples.links.alpha[:, 1:].reshape(-1, samples.count)
        depth = np.maximum(-self.runner.contact.centres(samples)[0][2], 0)
        excess = np.sum(samples.q**2, axis=0) - 1
        parts = [states[2, :, :3].T, alpha, np.sqrt(DEPTH_WEIGHT) * depth, np.sqrt(GAUGE) * excess]
        return self.root * np.concatenate(parts)

    def residual(self, x: Array) -> Array:
        """(R S, k) of x (n, k), a few columns at a time."""
        columns = x.reshape(x.shape[0], -1)
        out = []
        for first in range(0, columns.shape[1], CHUNK):
            states = self.unknowns.states(columns[:, first : first + CHUNK])
            count = states.shape[1]
            values = self.of_states(states.reshape(3, -1, self.figure.width))
            out.append(values.reshape(values.shape[0], count, -1).transpose(2, 0, 1).reshape(-1, count))
        return np.concatenate(out, axis=1).reshape(-1, *x.shape[1:])

    @cached_property
    def colours(self) -> list[tuple[int, Array]]:
        """(order, columns of y) that can be moved together because no residual sees two of them."""
        tables = self.figure.tables
        blocks = tables.quaternion_columns
        depth = tables.path[1:, 1:].sum(axis=1).astype(int)
        groups = [(order, blocks[i]) for order in (1, 2) for i in range(4)]
        groups += [(0, blocks[i, depth == level]) for level in np.unique(depth) for i in range(4)]
        return [*groups, (0, np.array([2])), (2, np.array([0])), (2, np.array([1])), (2, np.array([2]))]

    @cached_property
    def sparsity(self) -> NDArray[np.bool_]:
        """(R, N): whether a residual depends on a column of y, y' or y''."""
        figure = self.figure
        count = figure.tables.quaternion_links.size
        out = np.zeros((3 + 3 * count + len(SOLES) + count, figure.width), bool)
        out[[0, 1, 2], [0, 1, 2]] = True
        for body, columns in enumerate(figure.tables.quaternion_columns.T):
            for i in range(3):
                out[3 + i * count + body, columns] = True
            out[3 + 3 * count + len(SOLES) + body, columns] = True
        for row, point in enumerate(self.runner.contact.points, 3 + 3 * count):
            out[row, 2] = True
            for link, columns in zip(figure.tables.quaternion_links, figure.tables.quaternion_columns.T, strict=True):
                out[row, columns] = figure.tables.path[point.link, link] > 0
        return out

    def jacobian(self, x: Array, residual: Array) -> Array:
        """(R S, n): coloured differences of the states' residuals, times the spline's matrices."""
        states = self.unknowns.states(x.reshape(-1, 1))[:, 0]
        here = residual.reshape(SAMPLES, -1).T
        local = np.zeros((3, SAMPLES, here.shape[0], self.figure.width))
        for order, columns in self.colours:
            moved, h = states.copy(), 1e-7 * (1 + np.abs(states[order]).max())
            moved[order][:, columns] += h
            slope = (self.of_states(moved) - here).T / h
            for column in columns:
                visible = self.sparsity[:, column]
                local[order][:, visible, column] = slope[:, visible]
        moving = self.unknowns.moving
        out = np.zeros((SAMPLES, here.shape[0], moving.shape[2], self.figure.width))
        for order in range(3):
            out += local[order][:, :, None, :] * moving[order][:, None, :, None]
        return out.reshape(residual.size, x.size)


def by_mujoco(problem: LeastSquares, analytic: bool) -> list[Iterate]:
    """Every point at which the tool evaluates a residual vector, in order."""
    minimize = importlib.import_module("mujoco.minimize")
    iterates: list[tuple[float, Array]] = []
    begin = time.perf_counter()

    def residual(x: Array) -> Array:
        value = problem.residual(x)
        if x.reshape(x.shape[0], -1).shape[1] == 1:
            iterates.append((time.perf_counter() - begin, np.array(x).ravel()))
        return value

    more: dict[str, Any] = {"jacobian": problem.jacobian} if analytic else {}
    minimize.least_squares(
        problem.unknowns.start, residual, max_iter=MUJOCO_ITERATIONS, verbose=minimize.Verbosity.SILENT, **more
    )
    return [(t, problem.unknowns.path_of(x)) for t, x in iterates]


class Casadi:
    """The objective in CasADi's symbols, one sample's expression mapped over all, and IPOPT on it."""

    def __init__(self, casadi: Any, runner: Runner, unknowns: Unknowns, jit: bool) -> None:
        self.ca, self.unknowns = casadi, unknowns
        n, width = unknowns.free.size, runner.figure.width
        x = casadi.MX.sym("x", n * width)
        rows = casadi.reshape(x, width, n)
        parts = [
            casadi.mtimes(rows, casadi.DM(unknowns.moving[k].T)) + casadi.DM(unknowns.constant[k].T) for k in range(3)
        ]
        mapped = self.sample(runner).map(SAMPLES)
        value = unknowns.weights[0] * casadi.sum2(mapped(*parts))
        self.iterates: list[tuple[float, Array]] = []
        self.begin = 0.0
        self.callback = noting(casadi, x.numel(), self.note)
        options = {
            "ipopt": {
                "hessian_approximation": "limited-memory",
                "print_level": 0,
                "sb": "yes",
                "max_iter": CASADI_ITERATIONS,
                "tol": 1e-6,
            },
            "print_time": False,
            "iteration_callback": self.callback,
        }
        if jit:
            options |= {"jit": True, "compiler": "shell", "jit_options": {"flags": ["-O3", "-march=native"]}}
        self.solve = casadi.nlpsol("solve", "ipopt", {"x": x, "f": value}, options)

    def sample(self, runner: Runner) -> Any:
        """f(y, y', y'') of one sample, scalar expressions."""
        ca, figure = self.ca, runner.figure
        y, y_d, y_dd = (ca.SX.sym(name, figure.width) for name in ("y", "v", "a"))
        value = ca.sumsqr(y_dd[:3])
        turns: dict[int, Any] = {}
        origins: dict[int, Any] = {}
        for link, columns in zip(figure.tables.quaternion_links, figure.tables.quaternion_columns.T, strict=True):
            first, last = int(columns[0]), int(columns[-1]) + 1
            q, v, a = y[first:last], y_d[first:last], y_dd[first:last]
            b = ca.sumsqr(q)
            omega, rate = 2 * _quotient(ca, v, q) / b, ca.dot(q, v) / b
            value += ca.sumsqr(2 * _quotient(ca, a, q) / b - 2 * rate * omega) + GAUGE * (b - 1) ** 2
            turns[int(link)] = _matrix(ca, q, b)
            this = figure.links[link]
            place = y[:3] if not origins else origins[this.parent] + ca.mtimes(turns[this.parent], ca.DM(this.offset))
            origins[int(link)] = place
        for point in runner.contact.points:
            height = (origins[point.link] + ca.mtimes(turns[point.link], ca.DM(point.position)))[2]
            value += DEPTH_WEIGHT * ca.fmax(-height, 0) ** 2
        return ca.Function("sample", [y, y_d, y_dd], [value])

    def note(self, x: Array) -> None:
        self.iterates.append((time.perf_counter() - self.begin, x))

    def run(self) -> list[Iterate]:
        """Every iterate that IPOPT reports."""
        self.iterates.clear()
        self.begin = time.perf_counter()
        self.solve(x0=self.unknowns.start)
        return [(t, self.unknowns.path_of(x)) for t, x in self.iterates]


def _quotient(ca: Any, p: Any, q: Any) -> Any:
    """vec(p ⊗ conj(q))."""
    return ca.vertcat(
        p[1] * q[0] - p[0] * q[1] - p[2] * q[3] + p[3] * q[2],
        p[2] * q[0] - p[0] * q[2] - p[3] * q[1] + p[1] * q[3],
        p[3] * q[0] - p[0] * q[3] - p[1] * q[2] + p[2] * q[1],
    )


def _matrix(ca: Any, q: Any, b: Any) -> Any:
    """The rotation matrix of a quaternion of squared length b."""
    w, x, y, z = (q[i] for i in range(4))
    rows = (
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    )
    return ca.vertcat(*(ca.horzcat(*row) for row in rows)) / b


def noting(ca: Any, size: int, note: Callable[[Array], None], constraints: int = 0) -> Any:
    """IPOPT's iteration callback that hands every x to `note`."""

    class Recorder(ca.Callback):
        def __init__(self) -> None:
            ca.Callback.__init__(self)
            self.construct("noted", {})

        def get_n_in(self) -> int:
            return ca.nlpsol_n_out()

        def get_n_out(self) -> int:
            return 1

        def get_sparsity_in(self, i: int) -> Any:
            sizes = {"x": size, "lam_x": size, "f": 1, "g": constraints, "lam_g": constraints}
            rows = sizes.get(ca.nlpsol_out(i), 0)
            return ca.Sparsity.dense(rows, 1 if rows else 0)

        def eval(self, arg: Any) -> list[int]:
            note(np.array(arg[0]).ravel())
            return [0]

    return Recorder()


@dataclass
class Judged:
    """A method's runs against the optimum: seconds to 0.5 % (infinite: never), its last value, how many iterates."""

    clock: list[float]
    total: list[float]
    last: float
    last_sampled: float
    iterates: int


def judged(runner: Runner, runs: list[list[Iterate]], optimum: float) -> Judged:
    """The clock of every run; the iterates of the first are valued, the others' are the same points."""
    values = [runner.value(path) for _, path in runs[0]]
    first = next((i for i, value in enumerate(values) if value <= WITHIN * optimum), None)
    same = [run for run in runs if len(run) == len(values)]
    clock = [run[first][0] if first is not None else np.inf for run in same]
    best = int(np.argmin(values))
    end = runs[0][best][1]
    return Judged(clock, [run[-1][0] for run in runs], values[best], runner.value_on_samples(end), len(values))


def finest(runner: Runner, ends: list[Path]) -> tuple[float, Path]:
    """The lowest value at 15 variable frames a segment: from the raw spline, and on from every method's own end."""
    settings = Settings(
        variable=REFINED,
        frames=0,
        renormalise=False,
        quadrature=Quadrature("uniform", 641),
        tolerance=1e-9,
        max_evaluations=2000,
    )
    paths = [inbetween(Problem(runner.figure, runner.keys, runner.penalties, replace(settings, variable=FINEST))).path]
    paths += [_refined(runner, end, settings) for end in ends]
    values = [runner.value(path) for path in paths]
    return min(values), paths[int(np.argmin(values))]


def _split_evenly(timeline: Timeline, variable: int) -> Timeline:
    return split(timeline, Settings(variable=variable).beginning(timeline.times, in_windows=False))


def _refined(runner: Runner, end: Path, settings: Settings) -> Path:
    """15 frames a segment on a curve that is there, optimised on."""
    timeline = _split_evenly(runner.timeline.with_rows(end.rows), REFINED)
    objective = Objective.of(runner.figure, runner.penalties, quadrature=settings.quadrature)
    better = optimise(objective, timeline, max_evaluations=settings.max_evaluations, tolerance=1e-9)
    return Path(Spline(better.times), np.asarray(better.rows))


def methods(runner: Runner, unknowns: Unknowns, effort: Effort) -> tuple[dict[str, Callable], dict[str, float]]:
    """The methods to run alternately, and the duration of building each [s]."""
    least = LeastSquares(runner, unknowns)
    works: dict[str, Callable[[], list[Iterate]]] = {"ours": lambda: ours(runner)}
    building: dict[str, float] = {}
    casadi = peer("casadi")
    if casadi is not None:
        for name, jit in (("CasADi + IPOPT", False), ("CasADi + IPOPT, compiled by gcc -O3", True)):
            effort.report(f"building {name}")
            begin = time.perf_counter()
            try:
                built = Casadi(casadi, runner, unknowns, jit)
            except RuntimeError:  # no compiler here
                continue
            building[name] = time.perf_counter() - begin
            works[name] = built.run
    works["mujoco.minimize, its own differences"] = lambda: by_mujoco(least, False)
    works["mujoco.minimize, coloured Jacobian"] = lambda: by_mujoco(least, True)
    return works, building


def measure(effort: Effort) -> Section:
    # CasADi's compiler writes its files to the current folder
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder, contextlib.chdir(folder):
        return _measured(effort)


def _measured(effort: Effort) -> Section:
    runner = Runner.load()
    unknowns = Unknowns(runner)
    works, building = methods(runner, unknowns, effort)
    runs: dict[str, list[list[Iterate]]] = {name: [] for name in works}

    def result_of(name: str) -> Callable[[], None]:
        def work() -> None:
            effort.report(name)
            runs[name].append(works[name]())

        return work

    slow = [name for name in works if name.startswith("mujoco")]
    fast = {name: result_of(name) for name in works if name not in slow}
    for name in fast:
        effort.report(f"{name}, off the clock")
        works[name]()
    alternated(fast, effort.repeats, warm=False)
    repeats = {name: effort.count(3, 1) if "differences" in name else effort.repeats for name in slow}
    for turn in range(max(repeats.values())):
        alternated({"ours": result_of("ours")} | {n: result_of(n) for n in slow if turn < repeats[n]}, 1, warm=False)
    effort.report("optimum at 15 variable frames a segment")
    ends = [min((path for _, path in iterates[0]), key=runner.value) for iterates in runs.values()]
    optimum, best = finest(runner, ends)
    results = {name: judged(runner, iterates, optimum) for name, iterates in runs.items()}
    return _section(runner, results, building, optimum, best)


def _section(
    runner: Runner, results: dict[str, Judged], building: dict[str, float], optimum: float, best: Path
) -> Section:
    section = Section(
        "The 39-DOF runner: seconds until a path is within 0.5 % of the optimum, judged on 2001 samples",
        (
            "method",
            "to 0.5 % [s]",
            "× ours",
            "whole run [s]",
            "best / optimum",
            "the same on the 101",
            "iterates",
            "building [s]",
        ),
    )
    mine = median(results["ours"].clock)
    sampled = runner.value_on_samples(best)
    for name, got in results.items():
        clock = median(got.clock)
        reached_at = clock if np.isfinite(clock) else "never"
        times = clock / mine if np.isfinite(clock) else "–"
        share, share_sampled = f"{got.last / optimum:.5f}", f"{got.last_sampled / sampled:.5f}"
        building_time = building.get(name, "–")
        section.add(name, reached_at, times, median(got.total), share, share_sampled, got.iterates, building_time)
    if not any(name.startswith("CasADi") for name in results):
        section.add("CasADi + IPOPT", NOT_INSTALLED, *["–"] * 6)
    section.targets = [Target("ours to 0.5 %", mine, 0.2, unit="s")]
    targets = (("CasADi + IPOPT", 8.0), ("mujoco.minimize, its own", 20.0), ("mujoco.minimize, coloured", 20.0))
    for words, limit in targets:
        clocks = [median(got.clock) for name, got in results.items() if name.startswith(words)]
        fastest = min(clocks) / mine if clocks else None
        section.targets.append(
            Target(f"{words}{'' if 'CasADi' in words else ' …'}: its fastest / ours", fastest, limit, least=True)
        )
    section.notes = [
        f"optimum {optimum:.3f}: the lowest that 15 variable frames a segment reach, from the raw spline and from "
        "every method's own end; all methods have 3 a segment and two end slopes (867 unknowns), world quaternions, "
        "the same 101 equal samples, and start from the raw spline",
        "every iterate is judged on 2001 samples, without the gauge: root, angular and depth terms do not depend on "
        "the quaternions' length, so this is the normalised path's value, so violations between samples gain nothing",
        "on our clock: everything but loading the figure (timeline, spline, preconditioner, search). Not on CasADi's: "
        "building and compiling functions, spline matrices. Not on mujoco.minimize's: spline matrices",
        "CasADi: one sample's scalar expression mapped over all, exact gradients, IPOPT with limited-memory Hessian, "
        "MUMPS; iterates by its callback. mujoco.minimize: residuals of all samples and columns by our kinematics",
        "the coloured Jacobian differences one sample's residuals and multiplies by the spline's matrices; "
        "the tool's own differences move one unknown at a time; every trial point of the tool counts",
    ]
    section.data = {
        "optimum": optimum,
        "building": building,
        "methods": {name: {**got.__dict__} for name, got in results.items()},
    }
    return section
