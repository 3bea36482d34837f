"""The inputs of soft constraints, computed from keyframes and tables: soles, contacts, grasps, flights, gait cycle."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from mujoco import mjtGeom

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.contacts import ContactSchedule
from dynsplines.solver.contacts.stances import is_grounded
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.figure.dynamics import height
from dynsplines.solver.figure.figure import Figure, JointKind, Link
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.model import kinematics
from dynsplines.solver.figure.root import has_fixed_base
from dynsplines.solver.penalty import Bend, Person, Range, Support, holds
from dynsplines.solver.penalty.motion.people import PARTS
from dynsplines.solver.surface import Surface
from dynsplines.solver.surface.points import Point, body_points, bottoms_of, displacements
from dynsplines.solver.surface.surface import UPRIGHT
from dynsplines.solver.tolerances import NEGLIGIBLE

from ..errors import UserError, list_names, unknown
from ..scene.compose import compile_model, figure_spec
from ..scene.roles import roles
from .posing.places import Places

STEP = 0.2  # [1] shortest displacement of a foot in a step, relative to the height of the figure
KNEES, ELBOWS = ("knee", "shin"), ("elbow", "forearm", "farm")


@dataclass(frozen=True, eq=False)
class Context:
    """The inputs of soft constraints.

    Attributes:
        schedule: The schedule of contacts, with the figure, its keyframes or the samples of the recording that it
            follows, its sole points (or the sites listed for `collision`), and the surfaces of the scene.
        where: The name of the clip in error messages.
        bends: The knees and elbows on ball joints: all, or those listed for `limits`.
    """

    schedule: ContactSchedule
    where: str
    bends: tuple[Bend, ...] = ()

    def with_schedule(self, **changes: Any) -> Context:
        """Return the same inputs with changed fields of the schedule of contacts."""
        return replace(self, schedule=replace(self.schedule, **changes))

    @property
    def figure(self) -> Figure:
        """The figure."""
        return self.schedule.figure

    @property
    def keys(self) -> Timeline:
        """The keyframes."""
        return self.schedule.keys

    @property
    def points(self) -> tuple[Point, ...]:
        """The contact points of the soles."""
        return self.schedule.points

    @property
    def surfaces(self) -> tuple[Surface, ...]:
        """The surfaces of the scene."""
        return self.schedule.surfaces

    @property
    def is_tracking(self) -> bool:
        """Whether the soft constraints are those of a motion that follows a recording."""
        return self.schedule.is_recording

    @cached_property
    def body_above_soles(self) -> tuple[Point, ...]:
        """The points of the body, without those of feet and ankles below the resting soles, which these represent."""
        figure, body = self.figure, body_points(self.figure)
        if not body or not self.points:
            return body
        rest = Samples.of_qpos(figure)
        heights = bottoms_of((*body, *self.points), rest)[:, 0]
        soles = np.array([point.link for point in self.points])
        lowest = {link: heights[len(body) :][soles == link].min() for link in np.unique(soles).tolist()}
        flush = Thresholds.of(figure).tiny

        def is_below(point: Point, height: float) -> bool:
            feet = [link for link in lowest if point.link in (link, figure.links[link].parent)]
            return any(height < lowest[link] - flush for link in feet)

        return tuple(p for p, height in zip(body, heights.tolist(), strict=False) if not is_below(p, height))

    @cached_property
    def support(self) -> Support | None:
        """The forces that the schedule permits at the root's tree; None for a figure without a free joint."""
        schedule = self.schedule
        if schedule.root is None:
            return None
        return Support.of(self.figure, schedule.root, schedule.footings, schedule.flights)

    @property
    def is_free_sideways(self) -> bool:
        """Whether a keyframe leaves the horizontal position free of a figure that stands and does not travel."""
        root, keys = self.schedule.root, self.keys
        if root is None or self.is_tracking or not self.figure.gravity.any():
            return False
        columns = self.figure.links[root].qpos + np.arange(2)
        if keys.fixed[:, columns].all():
            return False
        moves = np.linalg.norm(np.diff(keys.states[:, columns], axis=0), axis=1)
        is_slow = np.all(moves < Thresholds.of(self.figure).travels * np.diff(keys.times))
        return bool(is_slow) and bool(self.schedule.footings)

    @cached_property
    def person(self) -> Person | None:
        """The figure as a person; None if it is none."""
        try:
            return person_of(self.figure, self.points)
        except ValueError:
            return None

    @property
    def is_stationary_at_ends(self) -> tuple[bool, bool]:
        """Whether the figure is stationary at the first and at the last keyframe.

        An end is stationary if its keyframe equals the neighbouring keyframe, if all feet are planted and the root is
        slow (0.5 m/s for an adult), or if the figure has a fixed base and no feet, like a robot arm. Both are False
        unless the clip has free ends. A partial keyframe is never stationary.
        """
        keys, schedule, limits = self.keys, self.schedule, Thresholds.of(self.figure)
        if keys.ends != "free":
            return False, False
        is_arm = not self.points and has_fixed_base(self.figure.model)
        feet, inferred = (
            {point.link for point in self.points},
            (*schedule.stances, *(contact for contact in schedule.on_ground if contact.is_placed)),
        )
        planted = (
            {stance.point.link for stance in inferred if stance.first <= keys.times[0]},
            {stance.point.link for stance in inferred if stance.last >= keys.times[-1]},
        )

        def is_stationary(end: int, neighbour: int, links: set[int]) -> bool:
            moves = keys.states[neighbour] - keys.states[end]
            if not keys.fixed[end].all():
                return False
            travel = np.linalg.norm(moves[self.figure.tables.position_columns[:2]], axis=0).max(initial=0.0)
            is_slow = travel < limits.travels * abs(keys.times[neighbour] - keys.times[end])
            return bool(is_arm or np.abs(moves).max() < NEGLIGIBLE or (feet and feet <= links and is_slow))

        return is_stationary(0, 1, planted[0]), is_stationary(-1, -2, planted[1])

    @property
    def missing_features(self) -> list[str]:
        """Notes on common features that the figure or its scene lacks."""
        lines: list[str] = []
        if not self.surfaces:
            lines.append("no static geom found: nothing to stay out of")
        if not self.points and self.figure.tables.free_links.size:
            lines.append("no feet found, nor a site named heel or toe: no contact points")
        if not self.bends and self.figure.tables.ball_links.size:
            lines.append("no knee, shin, elbow or forearm on a ball joint found: no limits on bending")
        free = [link.name for link in wheels(self.figure) if not self.keys.known[:, link.qpos].all()]
        if free:
            lines.append(
                f"nothing makes wheels roll ({', '.join(free)}): set their angles in every keyframe, distance / radius"
            )
        return lines

    @property
    def missing_steps(self) -> list[str]:
        """A note on pairs of neighbouring keyframes that imply steps which the motion will lack.

        In such a pair, both keyframes are complete and touch the ground, every foot has moved by more than a step, and
        no flight is between them. There is no note if the keyframes form a gait cycle.
        """
        keys, schedule, limits = self.keys, self.schedule, Thresholds.of(self.figure)
        if schedule.root is None or schedule.has_cycle is False or schedule.gait_cycle is not None or not self.points:
            return []
        feet = sorted({point.link for point in self.points if self.figure.tables.path[point.link, schedule.root]})
        places = Samples.still(self.figure, keys.states).links.x[:, feet]
        moves = displacements(places).min(axis=0, initial=np.inf)
        gaps, whole = np.diff(keys.times), keys.fixed.all(axis=1)
        stands = whole & is_grounded(schedule.soles)
        strides = moves > STEP * height(self.figure, schedule.root)
        lost = (gaps >= limits.far_apart) & strides & stands[:-1] & stands[1:]
        for first, last in schedule.flights:
            lost &= (keys.times[1:] <= first) | (last <= keys.times[:-1])
        if not feet or not lost.any():
            return []
        worst, others = int(np.where(lost, moves, 0.0).argmax()), int(lost.sum()) - 1
        more = f", as for {others} more pair{'s' if others > 1 else ''} of keyframes" if others else ""
        return [
            f"keyframes {worst + 1} and {worst + 2}, {gaps[worst]:.2g} s apart, form no gait cycle, but "
            f"every foot moves {moves[worst]:.2g} m{more}; add keyframes in which one foot has landed, or [[penalty]] "
            "kind = 'cycle' with its period"
        ]

    @property
    def unmet_falls(self) -> list[str]:
        """A note on keyframes in the air that no free fall meets."""
        schedule = self.schedule
        if schedule.specified_flights is not None:
            return []
        return [
            f"no free fall meets the keyframes in the air from {fall.first:.2f} to {fall.last:.2f} s: keyframe "
            f"{fall.misses + 1} is {abs(fall.by):.2f} m too {'high' if fall.by > 0 else 'low'}; change its height by "
            "this, or the times of the keyframes"
            for fall in schedule.falls
            if not fall.is_met
        ]

    @property
    def drifting_objects(self) -> list[str]:
        """Notes on objects that a keyframe after their last hold does not place, so that they may drift."""
        schedule, keys, lines = self.schedule, self.keys, list[str]()
        for i in schedule.objects:
            link, last = self.figure.links[i], max((g.last for g in schedule.grasps if g.on == i), default=np.inf)
            after = keys.times > last + Thresholds.of(self.figure).lift_off
            loose = np.flatnonzero(after & ~keys.known[:, link.columns].all(axis=1))
            if loose.size:
                lines.append(
                    f"keyframe {loose[0] + 1} does not place '{link.name}', which nothing holds after {last:.4g} s, so "
                    f"it may move by itself; specify roots.{link.name} in this keyframe"
                )
        return lines

    @property
    def contacts_in_air(self) -> list[str]:
        """Notes on contacts at positions where no surface is near, so that nothing can supply their forces."""
        limits, soles, lines = Thresholds.of(self.figure), {point.name for point in self.points}, list[str]()
        for contact in self.schedule.on_ground if self.surfaces else ():
            reach = limits.clear if contact.point.name in soles else limits.out_of_reach  # a hand is thick
            if contact.places is not None:
                places, radii = contact.places.T[:, None], np.array([[contact.point.radius + reach]])
                if not any(surface.near(places, radii).any() for surface in self.surfaces):
                    lines.append(
                        f"contact of '{contact.point.name}' from {contact.first:g} to {contact.last:g} s: no static "
                        f"geom is within {reach:.2g} m of its position, so its forces come from nothing; correct the "
                        "position or the keyframes, or add an obstacle"
                    )
        return lines

    @cached_property
    def holds(self) -> list[Range]:
        """The values of joints that two neighbouring keyframes fix alike; none in loops and gait cycles."""
        if self.keys.ends == "periodic" or self.schedule.gait_cycle is not None:
            return []
        return holds(self.figure, self.keys, self.schedule.flights)

    def sites(self, names: Sequence[str]) -> tuple[Point, ...]:
        """Return the points with these names. Raises UserError for unknown names."""
        places = Places(self.figure, self.points)
        return tuple(places.named_point(name, f"{self.where}: penalty 'collision'") for name in names)

    def limbs(self, names: Sequence[str]) -> tuple[Bend, ...]:
        """Return the knees and elbows on joints with these names. Raises UserError for unknown names."""
        bends = {bend.name: bend for bend in self.bends}
        for name in names:
            if name not in bends:
                raise UserError(f"{self.where}: penalty 'limits': {unknown('joint', name, bends)}")
        return tuple(bends[name] for name in names)


def knees_and_elbows(figure: Figure) -> list[Bend]:
    """Return the ball joints named as knees or elbows, or on bodies so named, of a figure that faces x. At rest, both
    parts of the limb lie along the same axis, not to the side as in a T-pose; otherwise its bend is unknown."""
    bends, rest = [], _turned_at_rest(figure)
    for i, link in enumerate(figure.links[1:], start=1):
        names = f"{link.name} {figure.model.body(link.body).name}".lower()
        lateral = 1.0 if any(w in names for w in KNEES) else -1.0 if any(w in names for w in ELBOWS) else 0.0
        if lateral and link.kind is JointKind.BALL:
            down = quat.rotate(rest[i], link.centre - link.anchor)
            above = quat.rotate(rest[link.parent], link.offset - figure.links[link.parent].anchor)
            along = _principal(down * [1, 0, 1])
            if all(bone @ along >= UPRIGHT * np.linalg.norm(bone) for bone in (down, above)) and np.any(down):
                axes = np.array([[0.0, lateral, 0.0], along])
                bends.append(Bend(link.name, i, *quat.rotate(quat.inverse(rest[link.parent]), axes)))
    return bends


def wheels(figure: Figure) -> list[Link]:
    """Return the links that turn like wheels: on a hinge without a range, about the axis of a cylinder or through the
    centre of a sphere. A figure without a free root has none."""
    model = figure.model
    hinges = [link for link in figure.links[1:] if link.kind is JointKind.HINGE and not model.jnt_limited[link.joint]]
    if not hinges or not figure.tables.free_links.size:
        return []
    data = kinematics(model)

    def is_wheel(link: Link) -> bool:
        axis, geoms = data.xaxis[link.joint], np.flatnonzero(model.geom_bodyid == link.body)
        off = np.linalg.norm(np.cross(axis, data.geom_xpos[geoms] - data.xanchor[link.joint]), axis=1)
        is_along = np.abs(data.geom_xmat[geoms, 2::3] @ axis) > 1 - NEGLIGIBLE
        kinds = model.geom_type[geoms]
        is_round = (kinds == mjtGeom.mjGEOM_SPHERE) | ((kinds == mjtGeom.mjGEOM_CYLINDER) & is_along)
        return bool(np.any(is_round & (off < NEGLIGIBLE * model.geom_size[geoms, 0])))

    return [link for link in hinges if is_wheel(link)]


def _turned_at_rest(figure: Figure) -> list[Array]:
    """Return the orientation of every link in the world in the rest pose, wxyz quaternions (4,), the world first."""
    rotations = [np.array([1.0, 0, 0, 0])]
    for link in figure.links[1:]:
        rotations.append(quat.product(rotations[link.parent], link.turn))
    return rotations


def _principal(direction: Array) -> Array:
    """Return the coordinate axis nearest to a direction (3,). In the rest pose, limbs hang along such an axis."""
    axis = np.zeros(3)
    axis[np.argmax(np.abs(direction))] = np.sign(direction[np.argmax(np.abs(direction))])
    return axis


def person_of(figure: Figure, soles: Sequence[Point] = ()) -> Person:
    """Return the figure as a person.

    Args:
        soles: The contact points of the soles; without them, ankles are as high as in the recordings.

    Raises:
        ValueError: Parts are unknown, the pelvis has no free joint, or the figure does not stand in its rest pose.
    """
    model = figure.model
    names, parents = [model.body(i).name for i in range(1, model.nbody)], (model.body_parentid[1:] - 1).tolist()
    parts = {part: int(figure.body_link[1 + body]) for part, body in roles(names, parents).items()}
    missing = [part.replace("_", " ") for part in PARTS if part not in parts]
    if missing:
        raise ValueError(f"no body has a name of these parts: {list_names(missing)}")
    rest = Samples.of_qpos(figure)
    return Person.of(figure, parts, float(bottoms_of(tuple(soles), rest).min()) if soles else None)


def note_on(figure: str) -> str:
    """Return a note on the soft constraint `prior` in clips of a figure, by name or file; empty if it is on."""
    try:
        person = person_of(Figure(compile_model(figure_spec(figure), figure)))
    except ValueError as error:
        return f"; not for '{figure}': {error}"
    return "; on if listed, as the figure has hinges" if person.is_robot else ""
