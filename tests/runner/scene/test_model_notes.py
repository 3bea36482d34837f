"""Notes on the direction of gravity and on floors that are added above a model's own ground."""

from __future__ import annotations

import mujoco
import pytest

from dynsplines import Keyframe, build
from dynsplines.clip.obstacles import obstacles
from dynsplines.clip.table import SceneTable
from dynsplines.scene.compose import compose
from dynsplines.scene.model_notes import vertical_notes

PIT = """<mujoco><option gravity="{gravity}"/><worldbody>{floor}
<geom name="ground" type="box" size="5 5 .1" pos="0 0 {height}"/>
<body name="ball" pos="0 0 3"><freejoint/><geom name="ball" size=".1"/></body></worldbody></mujoco>"""
PLANE = '<geom type="plane" size="0 0 1" pos="0 0 -1"/>'


def notes(height: float = -1.1, floor: str = "", gravity: str = "0 0 -9.81", scene: str | None = None) -> list[str]:
    spec = mujoco.MjSpec.from_string(PIT.format(height=height, floor=floor, gravity=gravity))
    table = SceneTable.model_validate({"box": [{"size": [1, 1, 1], "position": [3, 0, -2]}]} if scene else {})
    return vertical_notes(compose(spec, obstacles(table)).model())


@pytest.mark.parametrize(
    ("gravity", "is_noted"),
    [
        ("0 0 -9.81", False),
        ("0 0 0", False),
        ("0.1 0 -9.81", False),
        ("2 0 -9", True),
        ("0 -9 0", True),
        ("0 0 9", True),
    ],
)
def test_a_gravity_that_is_not_along_z_is_noted(gravity, is_noted):
    lines = notes(floor=PLANE, gravity=gravity)
    assert [line.split("]")[0] for line in lines] == [f"gravity is [{', '.join(gravity.split())}"] * is_noted


@pytest.mark.parametrize(("height", "is_noted"), [(-1.1, True), (-0.11, True), (-0.1, False), (0.5, False)])
def test_a_floor_that_is_added_above_static_geoms_is_noted(height, is_noted):
    """The top of the box is at its height plus 0.1."""
    lines = notes(height, scene="box")
    assert [line.split(";")[0] for line in lines] == [
        "the model has no level plane, so a floor was added at z = 0 m, above ground"
    ] * is_noted


def test_a_floor_of_the_model_is_not_noted():
    assert notes(floor=PLANE) == []
    named = PLANE.replace("<geom", '<geom name="floor"').replace("-1", "0")
    assert notes(floor=named) == []


def test_a_clip_has_the_notes_of_its_model():
    model = PIT.format(height=-1.1, floor="", gravity="1 0 -9")
    keys = [Keyframe(t, root={"position": [t, 0, 1], "rotation": {"heading": 0}}) for t in (0.0, 1.0)]
    assert [line.split()[0] for line in build(model, keys).notes[:2]] == ["gravity", "the"]
