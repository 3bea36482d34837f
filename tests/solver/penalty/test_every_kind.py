"""Every kind of soft constraint on every figure: exact derivatives, residuals whose squares add up, and invariance."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest
from figures import (
    FLOOR,
    SLOPE,
    UP,
    figure_named,
    plane_below,
    random_points,
    stance_of,
    support_of,
    two_points,
    with_armature,
)
from gradients import curvature_of, penalty_slope, shifted, sides_of
from random_models import at_times, random_samples
from scipy.spatial.transform import Rotation

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Index
from dynsplines.solver.contacts import Contact
from dynsplines.solver.contacts.gait import Gait
from dynsplines.solver.contacts.keyframe_points import KeyframePoints
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.recording import Track
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import (
    Allowance,
    Attachment,
    Bend,
    BendLimits,
    Collision,
    Coupling,
    CouplingPenalty,
    CovariantAcceleration,
    Cycle,
    Flight,
    HoverPenalty,
    JointRange,
    PeakAcceleration,
    Penalty,
    Posture,
    Prior,
    Range,
    RootAcceleration,
    SelfContact,
    Skate,
    Speed,
    Sum,
    Torque,
    TrackingPenalty,
    UnitMagnitude,
    Upright,
)
from dynsplines.solver.penalty.block import Block, one_sided_residuals
from dynsplines.solver.penalty.joints.self_contact import Bar
from dynsplines.solver.surface import Box, Plane, Surface
from dynsplines.solver.surface.points import Point

Case = tuple[Penalty, Samples]
Kind = Callable[[Figure, np.random.Generator], Case]

TILTED = np.array([0.0, 0.6, 0.8])
BLOCK = Box("block", np.array([0.1, -0.2, 0.0]), np.eye(3), np.array([2.0, 1.5, 1.0]), buried=False)
STEP = Box("step", np.array([0.0, 0, -0.5]), np.eye(3), np.array([2.0, 2.5, 1.0]), buried=True)


def timed(figure: Figure, rng: np.random.Generator, count: int = 8) -> Samples:
    """Random samples at even times of two seconds."""
    return at_times(random_samples(figure, rng, count), np.linspace(0, 2, count))


def last(figure: Figure) -> int:
    return len(figure.links) - 1


def plain(penalty: Penalty, count: int = 5) -> Kind:
    return lambda figure, rng: (penalty, random_samples(figure, rng, count))


def armed(figure: Figure, rng: np.random.Generator) -> Case:
    return Torque(), random_samples(with_armature(figure, rng), rng)


def contact(*surfaces: Surface, allowed: bool = False) -> Kind:
    def case(figure: Figure, rng: np.random.Generator) -> Case:
        samples, points = timed(figure, rng), random_points(figure, rng)
        samples.y[:, 2] = -0.3
        allowance = Allowance(np.array([0.0, 0.8, 2]), rng.uniform(0, 0.1, (len(points), 3))) if allowed else None
        return Collision(points, surfaces, margin=0.02, allowed=allowance), samples

    return case


def carried(figure: Figure, rng: np.random.Generator) -> Case:
    """A block on the last link, and points of the others."""
    points = tuple(point for point in random_points(figure, rng) if point.link != last(figure))
    return Collision(points, (BLOCK,), carrier=last(figure)), random_samples(figure, rng, 8)


@dataclass(frozen=True, eq=False)
class Weighted(Penalty):
    """A penalty whose residuals have weights that differ from sample to sample."""

    plain: Penalty
    name = "weighted"
    normalization = Collision.normalization

    def residuals(self, samples: Samples) -> Iterator[Block]:
        for block in self.plain.residuals(samples):
            assert isinstance(block, Block)
            yield replace(block, weight=1.5 + np.sin(block.at))


def weighted(figure: Figure, rng: np.random.Generator) -> Case:
    penalty, samples = contact(FLOOR)(figure, rng)
    return Weighted(penalty), samples


def self_contact(figure: Figure, rng: np.random.Generator) -> Case:
    bars = tuple(Bar(i, link, 0.2 * TILTED, UP, 0.3, 0.9) for i, link in enumerate((1, last(figure), 1)))
    return SelfContact(bars, np.array([[0, 1], [1, 2]]), 0.02), random_samples(figure, rng, 8)


def added(*kinds: Kind) -> Kind:
    def case(figure: Figure, rng: np.random.Generator) -> Case:
        cases = [kind(figure, rng) for kind in kinds]
        return Sum(tuple(penalty for penalty, _ in cases), "sum"), cases[-1][1]

    return case


def skate(normal: Array) -> Kind:
    def case(figure: Figure, rng: np.random.Generator) -> Case:
        samples = random_samples(figure, rng, 6)
        return Skate(two_points(figure), (plane_below(samples, normal),), 1.0), samples

    return case


def hover(figure: Figure, rng: np.random.Generator) -> Case:
    samples = random_samples(figure, rng, 6)
    return HoverPenalty(two_points(figure), (plane_below(samples),), reach=0.8, blend=0.2), samples


def planted(figure: Figure, rng: np.random.Generator) -> Case:
    stances = stance_of(1, 0.2, 1.0), stance_of(last(figure), 0.5, 2.0), stance_of(last(figure), 0.0, 0.6)
    return Attachment(stances), timed(figure, rng)


def resting(figure: Figure, rng: np.random.Generator) -> Case:
    end, tilt = last(figure), np.array([0.28, 0, 0.96])
    slope = Plane("slope", 3 * tilt, tilt)
    rests = (
        Contact(Point("a", 1, np.array([0.1, 0.2, -0.3]), 0.05), 0.1, 0.5, rolls=True),
        Contact(Point("b", end, UP), 0.3, 1.0),
        Contact(Point("c", end, np.array([0.2, 0.1, 0.0]), 0.02), 0.1, 1.9, surface=slope, rolls=True),
        Contact(Point("d", end, np.array([0.0, 0.1, 0.2]), 0.03), 0.2, 0.8),
    )
    return Attachment(rests, (Plane("floor", -50 * UP, UP),)), timed(figure, rng)


def grasp(*, is_known: bool) -> Kind:
    def case(figure: Figure, rng: np.random.Generator) -> Case:
        hand, end, times = Point("hand", 1, np.array([0.1, 0.2, -0.3])), last(figure), np.array([0.1, 0.8, 1.6])
        places = np.array([[0.1, 0, 0.2], [0.1, 0.3, 0], [0.1, 0.3, 0]])
        known = Contact(hand, 0.1, 1.6, end, places, times, slack=np.array([0.0, 0.3, 0.7]))
        return Attachment((known if is_known else Contact(hand, 0.1, 1.6, end),)), timed(figure, rng)

    return case


def flight(angular: float) -> Kind:
    return lambda figure, rng: (Flight.of(figure, 1, ((0.2, 0.8), (1.2, 1.6)), angular), timed(figure, rng))


def bends(*, allowed: bool) -> Kind:
    def case(figure: Figure, rng: np.random.Generator) -> Case:
        lateral = (np.array([0.0, -1, 0]), np.array([0.0, 1, 0]))
        joints = tuple(Bend(f"b{i}", i, lateral[i % 2], -UP) for i in figure.tables.ball_links.tolist())
        limits = BendLimits(joints, least=0.3, sideways=0.2, twist=0.1)
        excess = Allowance(np.array([0.0, 0.4, 2]), rng.uniform(0, 0.6, (5, len(joints), 3)))
        return (replace(limits, allowed=excess) if allowed else limits), timed(figure, rng)

    return case


def coupled(figure: Figure, rng: np.random.Generator) -> Case:
    """Hinges and slides, or else coordinates of roots, each of which follows the one before."""
    tables = figure.tables
    columns = [
        *tables.hinge_columns.tolist(),
        *tables.slide_columns.tolist(),
    ] or tables.position_columns.ravel().tolist()
    coefficients = np.array([0.3, 0.5, -0.2, 0.3, 0.7])
    followers = zip(columns, [-1, *columns[:-1]], strict=True)
    couplings = tuple(Coupling(f"{a}", a, b, (0.1, -0.2), coefficients, "degrees") for a, b in followers)
    return CouplingPenalty(couplings), random_samples(figure, rng)


def ranges(figure: Figure, rng: np.random.Generator, **during: Any) -> tuple[Range, ...]:
    """Every joint near a value."""
    out = []
    for i, link in enumerate(figure.links[1:], start=1):
        if link.kind in (JointKind.FREE, JointKind.BALL):
            home = tuple(Rotation.random(random_state=rng).as_quat(scalar_first=True).tolist())
            out.append(Range(link.name, i, JointKind.BALL, 0.0, 0.3, home=home, **during))
        if link.kind is JointKind.FREE:
            out += [Range(link.name, i, JointKind.SLIDE, -0.1, 0.2, axis, **during) for axis in range(3)]
        elif link.kind is not JointKind.BALL:
            out.append(Range(link.name, i, link.kind, -0.2, 0.1, **during))
    return tuple(out)


def joint_range(figure: Figure, rng: np.random.Generator) -> Case:
    return JointRange(ranges(figure, rng)), random_samples(figure, rng, 12)


def overshoot(figure: Figure, rng: np.random.Generator) -> Case:
    return JointRange(ranges(figure, rng, first=0.2, last=1.4)), timed(figure, rng, 9)


def upright(figure: Figure, rng: np.random.Generator) -> Case:
    bodies = np.flatnonzero(figure.body_link)[:3].tolist()
    return Upright.of(figure, bodies), random_samples(figure, rng, 5)


def tracking(figure: Figure, rng: np.random.Generator) -> Case:
    times = np.linspace(0, 2, 61)
    states = figure.to_state(figure.model.qpos0 + 0.3 * np.sin(3 * times[:, None] + rng.uniform(0, 6, figure.width)))
    penalty = TrackingPenalty(Track(figure, times, states, np.ones_like(states)))
    return penalty, at_times(random_samples(figure, rng), rng.uniform(0.1, 1.9, 5))


def prior(figure: Figure, rng: np.random.Generator) -> Case:
    """Random states at four instants of two segments, the second of which has weights of zero."""
    tables, links = figure.tables, np.arange(1, len(figure.links))
    positions, columns = tables.position_columns[:, :1].ravel(), np.full((links.size, 4), -1)
    for link, quaternion in zip(tables.quaternion_links, tables.quaternion_columns.T, strict=True):
        if tables.in_world[link]:
            columns[link - 1] = quaternion
    predicted = rng.normal(size=(2, 4, positions.size + columns.size))
    weights = np.repeat(rng.uniform(1, 2, (2, links.size)) * [[1.0], [0.0]], 4, axis=1)
    weights = np.concatenate([np.ones((2, positions.size)), weights], axis=1)
    return Prior(np.array([0.0, 1.2, 2.0]), positions, links, columns, predicted, weights), timed(figure, rng)


def cycle(figure: Figure, rng: np.random.Generator) -> Case:
    keys = [Frame.key(0.3 * k, qpos) for k, qpos in enumerate(figure.to_qpos(random_samples(figure, rng, 6).y))]
    gait_cycle = Gait(KeyframePoints.of(figure, raw_timeline(figure, keys), (), ())).with_period(0.7)
    assert gait_cycle is not None
    some = rng.choice(gait_cycle.times.size, 5, replace=False)
    return Cycle(figure, gait_cycle), at_times(random_samples(figure, rng), gait_cycle.times[some])


KINDS: dict[str, Kind] = {
    "covariant": plain(CovariantAcceleration()),
    "unit": plain(UnitMagnitude()),
    "root": plain(RootAcceleration()),
    "peak": plain(PeakAcceleration()),
    "posture": plain(Posture()),
    "cycle": cycle,
    "speed": lambda figure, rng: (Speed(0.5), random_samples(figure, rng)),
    "torque": plain(Torque()),
    "torque with armature": armed,
    "contact with a floor": contact(FLOOR),
    "contact with a slope": contact(SLOPE),
    "contact with a block": contact(BLOCK),
    "contact with a step": contact(STEP),
    "contact with a floor and a block": contact(FLOOR, BLOCK),
    "contact with an allowance": contact(FLOOR, allowed=True),
    "contact with what moves": carried,
    "contact with weights": weighted,
    "self-contact": self_contact,
    "skate": skate(UP),
    "skate on a slope": skate(TILTED),
    "hover": hover,
    "support": lambda figure, rng: (support_of(figure, rng), timed(figure, rng, 9)),
    "flight": flight(0.0),
    "flight with a moment": flight(0.7),
    "planted": planted,
    "rest": resting,
    "grasp": grasp(is_known=True),
    "grasp without a spot": grasp(is_known=False),
    "bend": bends(allowed=False),
    "bend with an allowance": bends(allowed=True),
    "coupling": coupled,
    "range": joint_range,
    "overshoot": overshoot,
    "upright": upright,
    "tracking": tracking,
    "prior": prior,
    "sum": added(contact(FLOOR), plain(Torque()), bends(allowed=False), contact(SLOPE)),
}
ONE_SIDED = ("contact", "self-contact", "bend", "range", "overshoot")  # kinds without other residuals
APPROXIMATE = {"peak", "skate", "skate on a slope", "support"}  # kinds with a model other than their Jacobian's square
OF_LENGTHS = {"unit", "tracking", "prior"}  # kinds that depend on the lengths of quaternions


@pytest.fixture(params=["ball tree, world", "every joint", "mixed"])
def figure(request: pytest.FixtureRequest) -> Figure:
    return figure_named(request.param)


@pytest.fixture(params=KINDS)
def kind(request: pytest.FixtureRequest) -> str:
    return request.param


def test_the_gradient_has_taylor_slope_two(kind: str, figure: Figure, rng: np.random.Generator) -> None:
    penalty, samples = KINDS[kind](figure, rng)
    assert penalty.evaluate(samples).any() or (kind.startswith("bend") and not figure.tables.ball_links.size)
    assert penalty_slope(penalty, samples, rng, any_length=kind not in OF_LENGTHS) > 1.9


def two_sided(penalty: Penalty, samples: Samples) -> list[tuple[Array, Index]]:
    """The residuals of which the model consists, without the one-sided ones, each with its samples."""
    blocks = [block for block in penalty.residuals(samples) if not (isinstance(block, Block) and block.one_sided)]
    every = np.arange(samples.count)
    return [(np.sqrt(getattr(block, "weight", 1.0)) * block.value, getattr(block, "at", every)) for block in blocks]


@pytest.mark.parametrize("name", [name for name in KINDS if name not in APPROXIMATE])
def test_the_curvature_is_twice_the_square_of_the_residuals_jacobian(name, figure, rng) -> None:
    """Along one direction, in other shares of y, y' and y'' at every sample."""
    penalty, samples = KINDS[name](figure, rng)
    phi, scale = rng.normal(size=(samples.count, 3)), rng.uniform(0.5, 2, samples.count)
    direction, h = rng.normal(size=figure.width), 1e-5
    by = h * np.einsum("so,n->osn", phi, direction)
    ends = (two_sided(penalty, shifted(samples, step)) for step in (by, -by))
    changes = [((after - before) / (2 * h), at) for (after, at), (before, _) in zip(*ends, strict=True)]
    expected = sum(2 * float(np.sum(scale[at] * change**2)) for change, at in changes)
    matrix = curvature_of(penalty, samples, scale).quadratic(phi, 0, samples.count)
    np.testing.assert_allclose(direction @ matrix @ direction, expected, rtol=1e-4, atol=1e-9)


def test_one_sided_residuals_add_up_and_their_rows_are_their_gradients(kind, figure, rng) -> None:
    penalty, samples = KINDS[kind](figure, rng)
    sides = one_sided_residuals(penalty.residuals(samples), samples)
    if sides is None or not sides.at.size:
        return
    total = np.bincount(sides.at, np.maximum(sides.value, 0) ** 2, samples.count)
    if kind.startswith(ONE_SIDED):
        np.testing.assert_allclose(total, penalty.evaluate(samples), rtol=1e-9, atol=1e-15)
    direction, h = rng.normal(size=samples.y.shape), 1e-7
    by = h * np.stack([direction, 0 * direction, 0 * direction])
    after, before = sides_of(penalty, shifted(samples, by)), sides_of(penalty, shifted(samples, -by))
    np.testing.assert_array_equal(after.at, sides.at)
    np.testing.assert_array_equal(before.at, sides.at)
    slope = np.einsum("pn,pn->p", sides.rows, direction[sides.at])
    np.testing.assert_allclose((after.value - before.value) / (2 * h), slope, rtol=1e-4, atol=1e-5)


POWERS = {"covariant": 4, "root": 4, "peak": 16, "posture": 2, "skate": 2}  # of a clip's duration
TIMELESS = ("unit", "contact with a floor", "bend", "range", "upright", "planted", "overshoot")


@pytest.mark.parametrize("name", [*POWERS, *TIMELESS])
def test_a_clip_that_is_played_slower_costs_less_by_a_power(
    name: str, figure: Figure, rng: np.random.Generator
) -> None:
    penalty, samples = KINDS[name](figure, rng)
    power = POWERS.get(name, 0)
    assert penalty.normalization.time_power == power
    slower = Samples(figure, samples.y, samples.y_d / 3, samples.y_dd / 9, t=samples.t)
    np.testing.assert_allclose(penalty.evaluate(slower) * 3.0**power, penalty.evaluate(samples), rtol=1e-9)


PLACED = {"planted", "range", "cycle", "overshoot", "tracking", "prior", "contact with a slope", "skate on a slope"}
PLACED |= {
    "contact with a block",
    "contact with a step",
    "contact with a floor and a block",
    "rest",
    "support",
    "coupling",
    "sum",
}


@pytest.mark.parametrize("name", [name for name in KINDS if name not in PLACED])
def test_a_motion_moved_and_turned_about_the_vertical_costs_the_same(name, rng) -> None:
    penalty, samples = KINDS[name](figure_named("ball tree, joint"), rng)
    turn, shift = quat.from_rotation_vector(np.array([0.0, 0, 2.1])), np.array([1.3, -0.7, 0])
    moved = [np.array(part) for part in (samples.y, samples.y_d, samples.y_dd)]
    tables = samples.figure.tables
    for order, part in enumerate(moved):
        for columns in tables.position_columns.T:
            part[:, columns] = quat.rotate(turn, part[:, columns]) + (order == 0) * shift
        for i, columns in zip(tables.quaternion_links.tolist(), tables.quaternion_columns.T, strict=True):
            if tables.in_world[i] or samples.figure.links[i].kind is JointKind.FREE:
                part[:, columns] = quat.product(turn, part[:, columns])
    values = penalty.evaluate(Samples(samples.figure, *moved, t=samples.t))
    np.testing.assert_allclose(values, penalty.evaluate(samples), rtol=1e-7, atol=1e-10)


def test_what_is_tolerated_is_linear_between_keyframes_and_constant_before_and_after(rng):
    times, excess, t = np.array([0.0, 0.8, 2]), rng.uniform(0, 1, (2, 3)), np.linspace(-1, 3, 41)
    allowance, expected = Allowance(times, excess), np.array([np.interp(t, times, row) for row in excess])
    np.testing.assert_allclose(allowance.at(t), expected)
    np.testing.assert_allclose(allowance.of(np.ones(t.size, int), t), expected[1])
