"""Whatever holds a model makes the same clip; notes on the direction of gravity and on floors that are added."""

import re
from pathlib import Path

import environment
import mujoco
import numpy as np
import pytest
from figures import stl
from PIL import Image
from texts import read_data

from dynsplines import Keyframe, UserError, build, load, motion, solving
from dynsplines.clip import load as clip
from dynsplines.clip import starter
from dynsplines.clip.load import obstacles
from dynsplines.clip.table import SceneTable
from dynsplines.picture.show import Look, images
from dynsplines.scene.compose import compose, figure_spec
from dynsplines.scene.model_notes import fixed_base, vertical_notes
from dynsplines.solver.surface.touch import grounds

ARM = """<mujoco model="arm"><option gravity="0 0 -3.7"/><worldbody>
    <body name="upper"><joint name="elbow" axis="0 1 0"/>
    <geom name="g" size=".1" pos=".123456789 0 0"/></body></worldbody></mujoco>"""
KEYS = [Keyframe(0, joints={"elbow": 0.0}), Keyframe(1, joints={"elbow": 20.0})]


def test_text_a_path_and_a_spec_are_the_same_figure(tmp_path: Path):
    (tmp_path / "arm.xml").write_text(ARM)
    wanted = mujoco.MjModel.from_xml_string(ARM)
    for figure in (ARM, "\n" + ARM, tmp_path / "arm.xml", mujoco.MjSpec.from_string(ARM)):
        model = build(figure, KEYS).figure.model
        np.testing.assert_allclose(model.body("upper").ipos, wanted.body("upper").ipos, atol=1e-12)
        np.testing.assert_allclose(model.opt.gravity, wanted.opt.gravity)


@pytest.mark.parametrize(
    "figure", [3, ARM.encode(), "<mujoco>", "absent.xml", "<robot/>", mujoco.MjModel.from_xml_string(ARM)]
)
def test_what_holds_no_model_is_refused_in_one_line(figure: object):
    with pytest.raises(UserError) as raised:
        build(figure, KEYS)  # type: ignore[arg-type]
    assert "\n" not in str(raised.value)


def test_model_text_is_no_clip():
    with pytest.raises(UserError, match="MJCF text is a figure, not a clip"):
        load(ARM)


LINK = """<link name="{}"><inertial><mass value="1"/>
    <inertia ixx=".1" iyy=".1" izz=".1" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><mesh filename="absent.dae"/></geometry></visual>
    <collision><geometry><box size=".2 .2 .2"/></geometry></collision></link>"""
HIP = """<joint name="hip" type="revolute"><parent link="base"/><child link="leg"/><origin xyz="0 0 -.3"/>
    <axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="10" velocity="3"/></joint>"""
ROBOT = f'<robot name="u">{LINK.format("base")}{LINK.format("leg")}{HIP}</robot>'
DARK = ARM.replace('<option gravity="0 0 -3.7"/>', '<compiler discardvisual="true"/>')


@pytest.mark.parametrize(("name", "text"), [("robot.urdf", ROBOT), ("arm.xml", DARK)])
def test_a_model_that_discards_what_is_only_seen_has_the_stage(tmp_path: Path, name: str, text: str):
    (tmp_path / name).write_text(text)
    model = compose(figure_spec(str(tmp_path / name))).model()
    assert len(grounds(model)) == 1
    assert model.nlight > 0
    assert model.nmat > 0
    assert model.geom("floor").matid[0] >= 0


def test_a_urdf_whose_root_is_fixed_says_how_to_free_it(tmp_path: Path):
    path = tmp_path / "robot.urdf"
    path.write_text(ROBOT)
    said = fixed_base(str(path), figure_spec(str(path)).compile())
    assert said.startswith("the root link 'base' is fixed in the world; to let it move add to the URDF: ")
    path.write_text(ROBOT.replace("</robot>", re.sub(".*URDF: ", "", said) + "</robot>"))
    model = figure_spec(str(path)).compile()
    assert model.jnt_type.tolist() == [int(mujoco.mjtJoint.mjJNT_FREE), int(mujoco.mjtJoint.mjJNT_HINGE)]
    assert not fixed_base(str(path), model)
    assert "root.position" in starter.starter(str(path), tmp_path / "robot.toml")


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


CART = """<mujoco><worldbody><geom type="plane" size="3 3 .1"/><body pos="0 0 .1"><freejoint/><geom size=".05"/>
<body pos="0 .1 0" zaxis="0 1 0"><joint name="wheel" {joint}/><geom type="{geom}" size=".1 .02" pos="{at} 0 0"/></body>
</body></worldbody></mujoco>"""


@pytest.mark.parametrize(
    ("joint", "geom", "at", "ends", "is_noted"),
    [
        ("", "cylinder", 0, None, True),
        ("", "sphere", 0, None, True),
        ("", "cylinder", 0, 5.0, False),  # a keyframe sets its angle
        ("", "cylinder", 0.05, None, False),  # a crank
        ("", "capsule", 0, None, False),
        ('axis="1 0 0"', "cylinder", 0, None, False),
        ('range="-90 90" limited="true"', "cylinder", 0, None, False),
    ],
)
def test_wheels_whose_angle_is_free_are_noted(joint, geom, at, ends, is_noted):
    model, last = CART.format(joint=joint, geom=geom, at=at), {} if ends is None else {"wheel": ends}
    keys = [
        Keyframe(time, root={"position": [time, 0, 0.1]}, joints=joints)
        for time, joints in ((0.0, {"wheel": 0.0}), (1.0, last))
    ]
    assert any("(wheel)" in note for note in build(model, keys).notes) == is_noted


MODEL = read_data("assets.xml")


def png(folder: Path, name: str, colours: np.ndarray) -> None:
    Image.fromarray(colours.astype(np.uint8)).save(folder / name)


@pytest.fixture
def model(tmp_path: Path, rng: np.random.Generator) -> Path:
    """A model in a folder of its own, its files in others."""
    home = tmp_path / "somewhere"
    mesh = home / "parts" / "mesh"
    for folder in ("a", "b"):
        (mesh / folder).mkdir(parents=True)
    (mesh / "a" / "bone.stl").write_bytes(stl(0.1))
    (mesh / "b" / "bone.stl").write_bytes(stl(0.2))
    (mesh / "b" / "corner.obj").write_text(
        "v 0 0 0\nv .1 0 0\nv 0 .1 0\nv 0 0 .1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
    )
    (home / "parts" / "more.xml").write_text("<mujoco><option gravity='0 0 -3'/></mujoco>")
    png(mesh, "hill.png", rng.integers(0, 255, (8, 8)))
    png(home / "parts", "wood.png", rng.integers(0, 255, (16, 16, 3)))
    png(home / "parts", "side.png", rng.integers(0, 255, (16, 16, 3)))
    (home / "it.xml").write_text(MODEL)
    return home / "it.xml"


def test_all_files_come_along_once_and_files_of_one_name_stay_apart(model):
    scene = compose(figure_spec(str(model)))
    assert sorted(scene.assets) == ["bone.stl", "bone_2.stl", "corner.obj", "hill.png", "side.png", "wood.png"]
    before, after = mujoco.MjModel.from_xml_path(str(model)), scene.model()
    np.testing.assert_allclose(after.mesh_vert, before.mesh_vert, atol=1e-7)
    np.testing.assert_array_equal(after.hfield_data, before.hfield_data)
    assert after.opt.gravity[2] == -3
    own = before.tex_adr[0], before.tex_adr[0] + before.tex_width[0] * before.tex_height[0]
    at = after.texture("wood").adr[0]
    np.testing.assert_array_equal(after.tex_data[at : at + own[1] - own[0]], before.tex_data[own[0] : own[1]])


def at_rest(model: Path) -> motion.Saved:
    scene = compose(figure_spec(str(model)))
    rest = np.tile(scene.model().qpos0, (2, 1))
    return solving.raw_spline(clip.from_qpos("it", scene, np.arange(2.0), rest, 30.0, "it"))


@pytest.mark.slow
def test_a_motion_file_needs_no_other_files(model):
    found, target = at_rest(model), model.parent.parent / "it.npz"
    motion.save(found, target)
    for path in sorted(model.parent.rglob("*"), reverse=True):
        path.unlink() if path.is_file() else path.rmdir()
    again = motion.load(target)
    assert again.scene == found.scene
    assert again.figure.model.nmesh == 3
    (picture,) = images(again, Look(96, 64, only="after", at=0.3), environment.GRAPHICS)
    assert np.ptp(picture) > 50


def test_a_motion_file_of_the_first_format_still_loads(motion_file, tmp_path):
    old = tmp_path / "old.npz"
    with np.load(motion_file) as data:
        assert "asset_names" not in data
        np.savez(old, **{**data, "format_version": 1})  # type: ignore[arg-type]
    assert motion.load(old).scene.assets == {}


def test_a_motion_file_with_damaged_assets_is_refused(model, tmp_path):
    target, bad = tmp_path / "it.npz", tmp_path / "bad.npz"
    motion.save(at_rest(model), target)
    for damage in ("asset_0", "asset_names"):
        with np.load(target) as data:
            assert damage in data
            np.savez(bad, **{**data, damage: np.zeros(3)})  # type: ignore[arg-type]
        with pytest.raises(UserError, match="its arrays do not fit together"):
            motion.load(bad)
