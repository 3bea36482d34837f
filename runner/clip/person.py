"""The figure as a person, by the names of its bodies, for the soft constraint `prior`."""

from __future__ import annotations

from collections.abc import Sequence

from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Person
from dynsplines.solver.penalty.motion.people import PARTS
from dynsplines.solver.surface.points import Point, bottoms_of

from ..errors import list_names
from ..scene.compose import compile_model, figure_spec
from ..scene.roles import roles


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
