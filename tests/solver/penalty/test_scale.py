"""References, tolerances and the check of custom penalties."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import pytest
from figures import BALL, BALL_TREE, CHAIN, FLOOR, figure_of

from dynsplines import models
from dynsplines.solver import penalty as kinds
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.contacts import Contact
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty.block import Block, Dense, Entries
from dynsplines.solver.penalty.joints.self_contact import Bar, SelfContact
from dynsplines.solver.penalty.penalty import check
from dynsplines.solver.surface.points import Point

UP, X = np.array([0.0, 0, 1]), np.array([1.0, 0, 0])


ORIGIN = Point("middle", 1, np.zeros(3))


CENTIMETRE = {
    "contact": kinds.Collision((ORIGIN,), (FLOOR,)),
    "grounded": kinds.HoverPenalty((ORIGIN,), (FLOOR,), reach=10.0),
    "planted": kinds.Attachment((Contact.at(ORIGIN, -1, 1, np.zeros(3)),)),
    "resting": kinds.Attachment((Contact(ORIGIN, -1, 1),), (FLOOR,)),
    "closed": kinds.Attachment((Contact.at(ORIGIN, -np.inf, np.inf, np.zeros(3)),), name="closed"),
    "self": SelfContact((Bar(0, 1, 0 * UP, UP, 0.0, 0.1), Bar(1, 0, 0.19 * UP, UP, 0.0, 0.1)), np.array([[0], [1]])),
}  # fmt: skip


@pytest.mark.parametrize("name", CENTIMETRE)
def test_a_centimetre_counts_as_the_reference_specifies(name):
    figure, penalty = figure_of(BALL), CENTIMETRE[name]
    away = {"contact": -0.01, "self": 0.0}.get(name, 0.01)
    y = np.array([[0, 0, away, 1, 0, 0, 0.0]])
    still = Samples(figure, y, 0 * y, 0 * y, t=np.zeros(1))
    assert penalty.role.is_violation
    assert penalty.normalization.time_power == 0
    np.testing.assert_allclose(penalty.evaluate(still), penalty.normalization.reference, rtol=1e-5)
    both = kinds.Sum((penalty, kinds.UnitMagnitude()), "both")
    assert (both.normalization, both.is_sharp, both.role) == (penalty.normalization, penalty.is_sharp, penalty.role)


@pytest.mark.parametrize("kind", [kinds.Collision, kinds.HoverPenalty])
@pytest.mark.parametrize(("points", "surfaces"), [((), (FLOOR,)), ((ORIGIN,), ())])
def test_without_points_or_surfaces_nothing_costs_anything(kind, points, surfaces):
    y = np.array([[0, 0, -1.0, 1, 0, 0, 0]])
    assert not kind(points, surfaces).evaluate(Samples.still(figure_of(BALL), y)).any()


@pytest.mark.parametrize("degrees", [-1.0, 1.0])
def test_a_degree_beyond_a_joints_range_a_bends_bound_or_a_couplings_line_counts_as_the_reference_specifies(degrees):
    hinge = figure_of(CHAIN.format("hinge"), "joint")
    angle = float(np.radians(degrees))
    y = np.array([[1.0, 0, 0, 0, 0.4 + angle]])
    still = Samples(hinge, y, 0 * y, 0 * y)
    kind = hinge.links[2].kind
    of_range = kinds.JointRange((kinds.Range("hinge", 2, kind, *((0.4, 9.0) if degrees < 0 else (-9.0, 0.4))),))
    of_coupling = kinds.CouplingPenalty(
        (kinds.Coupling("hinge", 4, -1, (0.3, 0.0), np.array([0.1, 0, 0, 0, 0]), "degrees"),)
    )
    for penalty in (of_range, of_coupling):
        np.testing.assert_allclose(penalty.evaluate(still), penalty.normalization.reference)
        assert penalty.role.is_violation
    balls = figure_of(CHAIN.format("ball"), "joint")
    straight = quat.from_rotation_vector(np.array([0, 0.2 - np.radians(1), 0]))
    y = np.concatenate([[1.0, 0, 0, 0], straight])[None]
    knee = kinds.BendLimits((kinds.Bend("knee", 2, np.array([0.0, 1, 0]), -UP),), 0.2, 1.0, 1.0)
    np.testing.assert_allclose(knee.evaluate(Samples(balls, y, 0 * y, 0 * y)), knee.normalization.reference)


def test_a_knee_that_a_keyframe_bends_backward_may_do_so_near_it_and_nowhere_else():
    figure = figure_of(models.figure_text("human"))
    knee = next(link for link in figure.links if link.name == "left_knee")
    keys = []
    for i, angle in enumerate([20.0, -6.0, 20.0]):
        qpos = np.array(figure.model.qpos0)
        qpos[knee.qpos : knee.qpos + 4] = quat.from_rotation_vector(np.radians([0, angle, 0]))
        keys.append(Frame.key(float(i), qpos))
    timeline = raw_timeline(figure, keys)
    link = figure.links.index(knee)
    bend = kinds.Bend("left_knee", link, np.array([0.0, 1, 0]), np.array([0.0, 0, -1]))
    limits = kinds.BendLimits((bend,)).allowing(figure, timeline)
    assert limits.allowed is not None
    np.testing.assert_allclose(np.degrees(limits.allowed.excess[0]), [[0, 6, 0]], atol=1e-9)
    np.testing.assert_allclose(np.degrees(limits.allowed.at(np.array([0.5, 1.5]))[0]), [[3, 3]], atol=1e-9)
    fixed = np.ones(figure.width, bool)
    fixed[knee.qpos : knee.qpos + 4] = False
    partial = [keys[0], Frame(keys[1].time, keys[1].state, fixed), keys[2]]
    assert kinds.BendLimits((bend,)).allowing(figure, raw_timeline(figure, partial)).allowed is None


FIGURE = figure_of(BALL_TREE)


@dataclass(frozen=True)
class Power(kinds.Penalty):
    """Height to a power of the root's x', its gradient too large by a share."""

    power: int
    error: float = 0.0
    worth: float = 1.0

    @property
    def name(self) -> str:
        return "power"

    @property
    def normalization(self) -> kinds.Normalization:
        return kinds.Normalization(1.0)

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        x = samples.y_d[:, 0]
        height = np.sqrt(self.worth * (x**self.power + 20.0))

        def pulled_back(cotangent: Cotangent, bar: Array) -> None:
            if self.power:
                rate = self.worth * self.power * x ** (self.power - 1) / (2 * height)
                cotangent.buffer("y_d")[:, 0] += (1 + self.error) * bar[0] * rate

        yield Dense(height[None], pulled_back)


class Odd(Power):
    """The same, and what is wrong with it by `power`."""

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        values = np.ones(samples.count)
        values[1 + self.power] = (np.nan, -1e-9)[self.power]
        yield Dense(np.zeros((1, samples.count)), lambda cotangent, bar: None, more=values)


@pytest.mark.parametrize("power", [0, 1, 3, 4])
@pytest.mark.parametrize("worth", [1e-6, 1e6])
def test_an_exact_gradient_passes_even_of_what_is_flat_or_linear_and_in_any_unit(power, worth):
    for seed in range(2):
        check(Power(power, 0.0, worth), FIGURE, seed=seed)


@pytest.mark.parametrize("power", [1, 2, 3])
@pytest.mark.parametrize("error", [-0.02, 1.0])
def test_a_gradient_that_is_off_by_a_share_is_refused_with_its_slope_of_about_one(power, error):
    with pytest.raises(ValueError, match=r"^penalty 'power': its gradient is not that .* slope [01]\.\d\d, not 2$"):
        check(Power(power, error), FIGURE)
    with pytest.raises(ValueError, match=r"slope 1\.0\d, not 2"):
        check(Power(1, error), FIGURE)


@pytest.mark.parametrize(
    ("wrong", "words"), [(0, r"a value is nan; finite ones from 0 on are penalties"), (1, r"a value is -1e-09; finite")]
)
def test_values_that_are_none_are_refused(wrong, words):
    with pytest.raises(ValueError, match=words):
        check(Odd(wrong), FIGURE)


@dataclass(frozen=True)
class Excess(Power):
    """The excess of the root's x' over a bound, one-sided."""

    bound: float = 0.0

    def residuals(self, samples: Samples) -> Iterator[Block]:
        at = np.arange(samples.count)
        slope = Entries(at, 1, np.zeros_like(at), 1 + self.error)
        yield Block(at, samples.y_d[:, 0] - self.bound, (slope,), one_sided=True)


def test_a_one_sided_penalty_is_checked_only_where_a_residual_is_positive():
    check(Excess(1, bound=-1.0), FIGURE)
    with pytest.raises(ValueError, match=r"its gradient is not that"):
        check(Excess(1, error=1.0, bound=-1.0), FIGURE)
    for error in (0.0, 1.0):
        with pytest.raises(
            ValueError, match=r"^penalty 'power': no residual was positive .* nothing was checked; pass"
        ):
            check(Excess(1, error=error, bound=100.0), FIGURE)
