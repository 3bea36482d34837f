"""How measures are shown on a screen: of the values before and after, a line each, or some.

A function takes the two values of one measure; `before` is None in a report of long ago that did not have it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from .swings import words as swing_words

Line = tuple[str, str, str]  # what it is, before, after


def objective(before: float, after: float) -> Iterator[Line]:
    """E."""
    yield "objective", f"{before:.4g}", f"{after:.4g}"


def terms(before: dict[str, float], after: dict[str, float]) -> Iterator[Line]:
    """Every term's part of E."""
    for name in after:
        yield f"  {name}", f"{before.get(name, 0):.4g}", f"{after.get(name, 0):.4g}"


def penetration(before: dict[str, Any], after: dict[str, Any]) -> Iterator[Line]:
    """The deepest of any geom, and of every point of the soles."""
    every = "; none collides, all count" if after.get("all geoms count") else ""
    yield _line(f"deepest penetration of any geom{every}", before, after, _deepest)
    yield from _each(before["points"], after["points"], "  {}", _millimetres)


def in_itself(before: dict[str, Any], after: dict[str, Any]) -> Iterator[Line]:
    """Limbs in the trunk or in each other, where a clip asks for it."""
    if after:
        yield _line("deepest of the figure in itself", before, after, _deepest)


def bends(before: dict[str, Any], after: dict[str, Any]) -> Iterator[Line]:
    """Knees and elbows."""

    def words(angles: dict[str, float]) -> str:
        return f"{angles['backward']:.1f}° / {angles['sideways']:.1f}° / {angles['twist']:.1f}°"

    yield from _each(before, after, "{}: backward / sideways / twist", words)


def ranges(before: dict[str, Any], after: dict[str, Any]) -> Iterator[Line]:
    """The joint that is farthest beyond its range."""
    if after:
        yield _line("farthest beyond a joint's range", before, after, _beyond)


def equalities(before: dict[str, Any], after: dict[str, Any]) -> Iterator[Line]:
    """Joints off what they follow, loops that come apart."""

    def torn(found: dict[str, Any]) -> str:
        return f"{_millimetres(found['most, m'])}, {found['loop']}"

    if "coupled" in after:
        yield _line("farthest off what it follows", before["coupled"], after["coupled"], _beyond)
    if "closed" in after:
        yield _line("closed loops apart", before["closed"], after["closed"], torn)


def skate(before: dict[str, Any], after: dict[str, Any]) -> Iterator[Line]:
    """The way that soles slide, and how fast."""

    def words(found: dict[str, float]) -> str:
        return f"{_millimetres(found['path, m'])}, {found['speed, m/s']:.3f} m/s"

    yield from _each(before, after, "skate of {}", words)


def stances(before: list[dict[str, Any]] | None, after: list[dict[str, Any]]) -> Iterator[Line]:
    """Feet that keyframes plant: how far they lift and slide."""

    def words(found: dict[str, float]) -> str:
        return f"{_millimetres(found['lift, m'])} / {_millimetres(found['slide, m'])}"

    for one, two in zip(before or [], after, strict=False):
        yield _line(f"{two['points']} planted {_span(two)}: lift / slide", one, two, words)


def swings(before: dict[str, Any] | None, after: dict[str, Any]) -> Iterator[Line]:
    """How high feet are in between."""
    yield from _each(before or {}, after, "{} off the floor, every swing", swing_words)


def contacts(before: list[dict[str, Any]] | None, after: list[dict[str, Any]]) -> Iterator[Line]:
    """Points of the clip's contacts."""

    def words(found: dict[str, float]) -> str:
        return f"{_millimetres(found['moved, m'])} / {_millimetres(found['path, m'])}"

    for one, two in zip(before or [], after, strict=False):
        yield _line(f"{two['point']} rests {_span(two)}: moved / path", one, two, words)


def holds(before: list[dict[str, Any]] | None, after: list[dict[str, Any]]) -> Iterator[Line]:
    """Hands on what they hold."""
    for one, two in zip(before or [], after, strict=False):
        name = f"{two['hand']} on {two['body']} {_span(two)}: moved"
        yield _line(name, one, two, lambda found: _millimetres(found["moved, m"]))


def in_carried(before: dict[str, Any] | None, after: dict[str, Any]) -> Iterator[Line]:
    """The figure in what it carries."""
    if after:
        yield _line("deepest in what is carried", before, after, _deepest)


def off_their_places(before: dict[str, float], after: dict[str, float]) -> Iterator[Line]:
    """Points that the search was to place."""
    yield from _each(before, after, "{}, off its place", _millimetres)


def edge_clearance(before: dict[str, float], after: dict[str, float]) -> Iterator[Line]:
    """Feet over the edges of boxes."""
    for name, value in after.items():
        yield f"clearance of {name}", "", _millimetres(value)


def lengths(before: dict[str, float], after: dict[str, float]) -> Iterator[Line]:
    """The shortest and the longest quaternion."""
    yield _line("length of quaternions", before, after, lambda s: f"{s['shortest']:.4f} - {s['longest']:.4f}")


def keyframe_error(before: float, after: float) -> Iterator[Line]:
    """How far the path is off its keyframes."""
    yield "keyframe error", f"{before:.1e}", f"{after:.1e}"


def seam(before: dict[str, float], after: dict[str, float]) -> Iterator[Line]:
    """A loop's end beside its start."""

    def words(found: dict[str, float]) -> str:
        return " / ".join(f"{found[key]:.0e}" for key in ("state", "first derivative", "second derivative"))

    if "turn, degrees" in after:
        yield _line("a period turns by", before, after, lambda s: f"{s.get('turn, degrees', 0.0):.4g}°")
    yield _line("seam of the loop: y / y' / y'' apart", before, after, words)


def peak(before: dict[str, Any], after: dict[str, Any]) -> Iterator[Line]:
    """The joint that accelerates most."""
    yield _line("peak angular acceleration", before, after, lambda s: f"{s['peak']:.0f} rad/s², {s['joint']}")


def torque(before: dict[str, Any], after: dict[str, Any]) -> Iterator[Line]:
    """Joints' torques, and the force at the root."""
    name = "norm of all joints' torques, root mean square over time"
    yield _line(name, before, after, lambda t: f"{t['root mean square']:.0f} N m")
    yield _line("  peak of one joint", before, after, lambda t: f"{t['peak of one joint']:.0f} N m, {t['joint']}")
    yield _line("peak root force, the ground's to supply", before, after, lambda t: f"{t['peak root force']:.0f} N")


def support(before: dict[str, Any], after: dict[str, Any]) -> Iterator[Line]:
    """Free fall in flight, and what no contact can supply."""
    if "off free fall, g" in after:
        name = "in flight: centre of mass off g, mean"
        yield _line(name, before, after, lambda c: f"{c['off free fall, g']:.1%}")
        name = "  upward force from nothing, mean"
        yield _line(name, before, after, lambda c: f"{c['upward force in flight, N']:.0f} N")
    if after:
        name = "root force that no contact can supply, root mean square"
        yield _line(name, before, after, lambda c: f"{c['root mean square']:.2f} body weights")
        name = "  moment, body weight × height"
        yield _line(name, before, after, lambda c: f"{c['moment, root mean square']:.2f}")


def drift(after: dict[str, float]) -> Iterator[Line]:
    """How far the centre of mass is off where it was before."""
    yield "centre of mass off before, largest", "", _millimetres(after["largest"])
    yield "  away from where before is in a box", "", _millimetres(after["away from trouble"])


def _line(name: str, before: Any, after: Any, words: Callable[[Any], str]) -> Line:
    return name, words(before), words(after)


def _each(before: dict[str, Any], after: dict[str, Any], called: str, words: Callable[[Any], str]) -> Iterator[Line]:
    """A line on everything that there is after."""
    for name in after:
        yield _line(called.format(name), before[name], after[name], words)


def _millimetres(value: float) -> str:
    return f"{1000 * value:.1f} mm"


def _deepest(found: dict[str, Any]) -> str:
    return f"{_millimetres(found['deepest'])}, {found['where']}"


def _span(found: dict[str, Any]) -> str:
    return f"{found['from, s']:.2f} - {found['to, s']:.2f} s"


def _beyond(found: dict[str, Any]) -> str:
    """How far a joint is beyond its range, in words."""
    if found["most"] == 0:
        return "not at all"
    far = f"{found['most']:.1f}°" if found["unit"] == "degrees" else f"{1000 * found['most']:.1f} mm"
    return f"{far}, {found['joint']}"
