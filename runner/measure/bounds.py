"""Violations and their bounds; docs/check.md contains the same table of bounds."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Bound:
    """A kind of violation and its tolerance.

    most  largest tolerated amount in `unit`: "m", "degrees", "degrees/s", "rad/s²", or "" for none

    A whip is a sudden swing of a limb: a large angular acceleration of a link relative to its parent. "length" is that
    of quaternions, which should be 1.
    """

    kind: str
    most: float
    unit: str


BOUNDS = {
    bound.kind: bound
    for bound in (
        Bound("penetration", 0.005, "m"),  # more than a sole or skin gives
        Bound("self", 0.01, "m"),  # limbs are soft, and drawn thicker than they are
        Bound("contact", 0.01, "m"),  # a hand or foot that slips so far is seen to slip
        Bound("grasp", 0.005, "m"),  # grasped objects and hands are conspicuous
        Bound("grasp rotation", 5.0, "degrees"),  # of a body in a hand that holds it firmly
        Bound("hover", 0.01, "m"),  # as contact, of one that is to rest on whatever is below it
        Bound("aloft", 0.02, "m"),  # a home pose of a robot may be some millimetres above the floor
        Bound("float", 0.05, "m"),  # as much as feet in captured walks are above the ground between steps
        Bound("unsupported", 0.3, ""),  # of the weight; a captured run lacks 0.26, walks and steps 0.03
        Bound("toppling", 0.22, ""),  # of weight times height; a captured run lacks 0.15, a kick 0.12, walks 0.07
        Bound("unbalanced", 0.05, "m"),  # a captured kick on one leg has 22 mm, and soles are wider than their points
        Bound("slide", 0.05, "m"),  # more than a sole moves while it lands in a run
        Bound("drag", 0.1, "m"),  # heels and toes of captured feet scuff up to 7 cm
        Bound("stance", 0.02, "m"),  # stances inferred from keyframes are less certain than a clip's contacts
        Bound("backward", 3.0, "degrees"),  # a straight knee or elbow is never quite straight
        Bound("sideways", 3.0, "degrees"),  # beyond the clip's bound, 8° by default
        Bound("twist", 3.0, "degrees"),  # as sideways
        Bound("range", 2.0, "degrees"),  # a soft constraint gives about 1°
        Bound("travel", 0.005, "m"),  # of slides beyond their range
        Bound("overshoot", 10.0, "degrees"),  # a joint off a value that two neighbouring keyframes hold
        Bound("overshoot travel", 0.1, "m"),  # a slide, or the root, off its values in two neighbouring keyframes
        Bound("coupled", 1.0, "degrees"),  # a hinge off what it follows
        Bound("coupled travel", 0.002, "m"),  # a slide off what it follows
        Bound("torn", 0.005, "m"),  # points of a closed loop apart
        Bound("speed", 10.0, "degrees/s"),  # or 5 % of the limit, if that is more: a soft constraint gives as much
        Bound("whip", 500.0, "rad/s²"),  # or 4 times what the raw spline needs, if that is more; run_loop comes to 370
        Bound("length", 0.5, ""),  # quaternions so far from length 1 turn fast between samples
        Bound("search", 1.0, ""),  # the search ended early
    )
}
WHIP_SHARE = 4.0  # [1] multiple of the raw spline's largest angular acceleration that is tolerated
SPEED_SHARE = 0.05  # [1] share of a speed limit by which it may be exceeded


@dataclass(frozen=True)
class Violation:
    """A measured excess over a bound.

    Attributes:
        kind: Kind of violation, such as "penetration".
        name: Name of the point, joint or contact.
        time: Time of the largest amount [s]; None for a violation without a time.
        amount: Measured amount, in `unit`.
        unit: "m", "degrees", "degrees/s", "rad/s²" or "".
        bound: Tolerated amount, in `unit`.
        keyframe: Number of the keyframe that causes it, from 1; None if the motion between keyframes causes it.
        text: The violation as one line.
    """

    kind: str
    name: str
    time: float | None
    amount: float
    unit: str
    bound: float
    keyframe: int | None
    text: str

    @property
    def severity(self) -> float:
        """The amount divided by the bound."""
        return self.amount / self.bound

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True)
class Row:
    """A measured quantity, and the message on its violation.

    Attributes:
        kind: Kind of violation, a key of `BOUNDS`.
        name: Name of the point, joint or body.
        text: The message, with {} for the amount.
        bound: Tolerated amount, in `unit`.
        other: Name of the surface or of the second body.
    """

    kind: str
    name: str
    text: str
    bound: float
    other: str = ""

    @property
    def unit(self) -> str:
        return BOUNDS[self.kind].unit

    def violation(self, amount: float, time: float | None = None, keyframe: int = 0) -> Violation:
        """Return the violation by an amount at a time [s]; keyframe: the number of the faulty keyframe, 0 for none."""
        text = self.text.format(with_unit(amount, self.unit)) + ("" if time is None else f" at {time:.2f} s")
        if keyframe:
            text = f"keyframe {keyframe} itself: {text}"
        return Violation(self.kind, self.name, time, amount, self.unit, self.bound, keyframe or None, text)


def row_of(kind: str, name: str, text: str, bound: float | None = None, other: str = "") -> Row:
    """Return a row; by default its bound is that of its kind."""
    return Row(kind, name, text, BOUNDS[kind].most if bound is None else bound, other)


def with_unit(amount: float, unit: str) -> str:
    """Return an amount as text, lengths in millimetres below 1 m."""
    if unit == "m":
        return f"{1000 * amount:.0f} mm" if amount < 1 else f"{amount:.2f} m"
    if unit == "degrees":
        return f"{amount:.0f}°"
    if not unit:
        return f"{amount:.2f}"
    return f"{amount:.0f} {unit}" if amount >= 100 else f"{amount:.2g} {unit}"
