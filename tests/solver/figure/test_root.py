"""The root of a model: the articulated tree on legs, wherever it is listed."""

from __future__ import annotations

import itertools

import mujoco
import pytest
from figures import figure_of

from dynsplines.solver.figure.root import has_fixed_base, root_of, sliding_joints
from tests.support.biped import BALL, BOX, CART, DOOR, DRAWER, biped, joints, scene

PLANAR = biped(joints(("tx", "tz", "ry")))
ARM = '<body><joint axis="0 0 1"/><geom size=".1"/><body pos=".2 0 0"><joint/><geom size=".1"/></body></body>'
RAIL = '<body><joint type="slide" axis="1 0 0"/><joint type="slide"/><geom size=".1"/></body>'


def root_bodies(xml: str) -> tuple[str, str] | None:
    """The root's body and joint, by name."""
    model = mujoco.MjModel.from_xml_string(xml)
    root = root_of(model)
    if root is None:
        return None
    return model.body(root.body).name, model.joint(root.joint).name


@pytest.mark.parametrize("order", list(itertools.permutations(range(3))))
@pytest.mark.parametrize("objects", [(BOX, BALL), (CART, DOOR), (BOX, DRAWER)])
def test_objects_may_be_listed_before_and_after_the_robot(objects: tuple[str, str], order: tuple[int, ...]) -> None:
    bodies = (biped(), *objects)
    assert root_bodies(scene(*(bodies[i] for i in order))) == ("pelvis", "root")


def test_of_two_robots_the_evidently_larger_one_is_the_figure() -> None:
    arms = "".join(f'<body pos="0 0 .{i}"><joint/><geom size=".05"/></body>' for i in range(1, 8))
    large = biped(prefix="b_", x=1.0, root='<freejoint name="b_root"/>').replace("</body>", arms + "</body>", 1)
    assert root_bodies(scene(biped(), large)) == ("b_pelvis", "b_root")


def test_two_robots_of_one_size_are_ambiguous() -> None:
    model = mujoco.MjModel.from_xml_string(scene(BOX, biped(), biped(prefix="b_", x=1.0, root="<freejoint/>")))
    root = root_of(model)
    assert root is not None and root.is_ambiguous
    assert [model.body(body).name for body in (root.body, *root.rivals)] == ["pelvis", "b_pelvis"]


def test_the_root_is_the_first_of_the_free_links() -> None:
    figure = figure_of(scene(BOX, biped(), BALL))
    named = [figure.links[i].name for i in figure.tables.free_links]
    assert named == ["root", "box_free", "ball"]
    assert figure.tables.position_columns[:, 0].tolist() == [7, 8, 9]


@pytest.mark.parametrize(
    ("bodies", "root", "sliding", "is_fixed"),
    [
        ((PLANAR, BOX), None, 3, False),
        ((PLANAR, DRAWER, biped(prefix="b_", root='<freejoint name="b"/>')), ("b_pelvis", "b"), 3, False),
        ((ARM,), None, 0, True),
        ((ARM, RAIL, BOX), ("box", "box_free"), 0, True),
        ((RAIL,), None, 0, False),
        ((BOX,), ("box", "box_free"), 0, False),
    ],
)
def test_slides_and_hinges_are_no_root(
    bodies: tuple[str, ...], root: tuple[str, str] | None, sliding: int, is_fixed: bool
) -> None:
    assert root_bodies(scene(*bodies)) == root
    model = mujoco.MjModel.from_xml_string(scene(*bodies))
    assert (len(sliding_joints(model)), has_fixed_base(model)) == (sliding, is_fixed)
