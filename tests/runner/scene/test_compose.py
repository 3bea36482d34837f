"""Figure and stage become one MJCF text, which needs nothing else and moves as the figure did."""

import re
import tomllib
from pathlib import Path

import mujoco
import numpy as np
import pytest
from oracles import kinematics
from problems import FIGURE, HINGE, names

from dynsplines import models
from dynsplines.clip.load import obstacles
from dynsplines.clip.table import SceneTable, StepTable
from dynsplines.errors import UserError
from dynsplines.scene import mujoco_versions as versions
from dynsplines.scene.compose import compose, figure_spec
from dynsplines.system.mujoco_warnings import quietly

OWN_STAGE = """<worldbody>
  <light name="lamp" directional="true" dir="0 0 -1"/><geom name="ground" type="plane" size="1 1 1" contype="1"/>"""


def spec_of(text: str) -> mujoco.MjSpec:
    return mujoco.MjSpec.from_string(text)


def composed(text: str, **step: float) -> mujoco.MjModel:
    scene = SceneTable(step=StepTable(**step) if step else None)
    return compose(spec_of(text), obstacles(scene)).model()


def named(model: mujoco.MjModel, kind: str) -> set[str]:
    count = {"geom": model.ngeom, "light": model.nlight, "camera": model.ncam}[kind]
    return {getattr(model, kind)(i).name for i in range(count)}


def test_a_bare_figure_gets_floor_light_and_sky():
    model = composed(FIGURE)
    assert named(model, "geom") == {"trunk", "shin", "floor"}
    assert model.nlight > 0
    assert int(mujoco.mjtTexture.mjTEXTURE_SKYBOX) in model.tex_type
    floor = model.geom("floor")
    assert floor.type[0] == mujoco.mjtGeom.mjGEOM_PLANE
    assert floor.contype[0] == floor.conaffinity[0] == 0


def test_a_model_that_brings_floor_and_light_keeps_its_own_and_a_wall_is_no_floor():
    model = composed(FIGURE.replace("<worldbody>", OWN_STAGE, 1))
    assert named(model, "geom") == {"trunk", "shin", "ground"}
    assert named(model, "light") == {"lamp"}
    assert model.geom("ground").contype[0] == 1
    wall = '<worldbody><geom name="wall" type="plane" zaxis="1 0 0" size="1 1 1"/>'
    assert named(composed(FIGURE.replace("<worldbody>", wall, 1)), "geom") == {"trunk", "shin", "wall", "floor"}
    assert named(composed(FIGURE.replace('"trunk"', '"floor"')), "geom") == {"floor", "shin", "stage_floor"}


def test_a_stage_changes_nothing_about_how_a_figure_moves():
    bare, staged = mujoco.MjModel.from_xml_string(FIGURE), composed(FIGURE, x=1.0, height=0.2)
    assert (bare.nq, bare.nv, bare.nbody) == (staged.nq, staged.nv, staged.nbody)
    np.testing.assert_allclose(staged.body_mass, bare.body_mass, rtol=1e-6)
    np.testing.assert_allclose(staged.opt.gravity, bare.opt.gravity)
    rng = np.random.default_rng(0)
    places = []
    qpos = rng.normal(size=bare.nq)
    for model in (bare, staged):
        data = kinematics(model, qpos)
        places.append(data.xipos.copy())
    np.testing.assert_allclose(places[0], places[1], atol=1e-6)
    keys = '<keyframe><key time="0" qpos="0 0"/><key time="1" qpos="1 1"/></keyframe>'
    assert composed(HINGE.format(keys=keys)).nkey == 0  # keyframes do not come along


def test_a_step_has_its_front_at_x_and_its_top_at_its_height():
    geom = composed(FIGURE, x=2.9, height=0.35, length=1.0, width=2.0, y=0.5).geom("step")
    np.testing.assert_allclose(geom.pos - geom.size, [2.9, -0.5, 0.0], atol=1e-6)
    np.testing.assert_allclose(geom.pos + geom.size, [3.9, 1.5, 0.35], atol=1e-6)


@pytest.mark.parametrize(
    "asset",
    [
        '<mesh name="m" file="m.obj"/>',
        '<hfield name="h" file="h.png" size="1 1 1 1"/>',
        '<texture name="t" type="cube" fileup="u.png"/>',
    ],
)
def test_a_file_that_is_not_there_is_reported(asset):
    with pytest.raises(UserError, match=r"refers to the file '\w\.\w+', which is not there"):
        compose(spec_of(FIGURE.replace("<worldbody>", f"<asset>{asset}</asset><worldbody>", 1)))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            FIGURE.replace("<worldbody>", '<worldbody><geom name="step" size="1"/>', 1),
            "has a box 'step', but the model already has a geom",
        ),
        (
            FIGURE.replace("<worldbody>", '<asset><material name="stage_step"/></asset><worldbody>', 1),
            "repeated name 'stage_step'",
        ),
        ('<mujoco><worldbody><body name="a"><joint/></body></worldbody></mujoco>', "mass and inertia"),
    ],
)
def test_a_model_whose_names_are_the_stages_or_that_cannot_be_compiled_is_refused_in_one_line(text, told):
    with pytest.raises(UserError, match=told) as caught:
        composed(text, x=1.0, height=0.2)
    assert "\n" not in str(caught.value)


def test_shipped_figures_come_by_name_and_others_by_path(tmp_path):
    for name in models.figures():
        assert figure_spec(name).compile().njnt > 0
    (tmp_path / "own.xml").write_text(FIGURE, encoding="utf-8")
    assert figure_spec("own.xml", tmp_path).compile().nq == 11


@pytest.mark.parametrize(
    ("figure", "words"),
    [("humn", "did you mean 'human'"), ("none.xml", "no file 'none.xml'"), (".", "no figure"), ("", "no figure")],
)
def test_a_figure_that_is_not_there_is_reported_with_those_that_are(tmp_path, figure, words):
    with pytest.raises(UserError, match=words) as caught:
        figure_spec(figure, tmp_path)
    assert "human" in str(caught.value)


@pytest.mark.parametrize("text", ["<mujoco", "", "<html/>", "\xff\x00"])
def test_a_file_that_is_no_mjcf_is_reported_in_one_line(tmp_path, text):
    (tmp_path / "bad.xml").write_bytes(text.encode("latin-1"))
    with pytest.raises(UserError, match=r"bad\.xml: MuJoCo cannot read it") as caught:
        figure_spec("bad.xml", tmp_path)
    assert "\n" not in str(caught.value)


def test_mujocos_warnings_leave_no_log_and_no_words(tmp_path, monkeypatch, capfd):
    monkeypatch.chdir(tmp_path)
    keys = '<keyframe><key time="0" qpos="nan 0"/></keyframe>'
    (tmp_path / "odd.xml").write_text(HINGE.format(keys=keys), encoding="utf-8")
    compose(figure_spec("odd.xml"))
    with quietly():
        print("hidden")
    assert names(tmp_path) == ["odd.xml"]
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    "lamp",
    [
        "",
        '<light name="lamp" pos="0 0 2" mode="trackcom"/>',
        '<light name="lamp" pos="0 0 9" dir="0 0 -1" active="false"/>',
    ],
)
def test_a_figure_in_the_dark_or_in_a_cone_of_light_is_seen_in_the_stages_light_alone(lamp):
    model = composed(FIGURE.replace("<worldbody>", f"<worldbody>{lamp}", 1))
    lit = {model.light(k).name for k in range(model.nlight) if model.light_active[k]}
    assert lit == {"stage_key", "stage_fill"}
    stage = mujoco.MjModel.from_xml_string(models.stage_text())
    np.testing.assert_allclose(model.vis.headlight.ambient, stage.vis.headlight.ambient)


GREY = """<mujoco><asset><material name="own" rgba="1 0 0 1"/></asset><worldbody>
  <geom name="ground" type="plane" size="1 1 1"/><geom name="post" type="box" size=".1 .1 .1" pos="3 0 .1"/>
  <body pos="0 0 1"><freejoint/><geom name="trunk" size=".1"/><geom name="red" size=".1" material="own"/>
    <geom name="hull" size=".2" group="3"/><geom name="green" size=".1" rgba="0 1 0 1"/>
    <body><geom name="pack" size=".1"/><body><joint/><geom name="arm" size=".1"/></body></body></body>
</worldbody></mujoco>"""


def test_what_has_no_colour_gets_materials_limbs_light_and_dark_in_turn():
    model = composed(GREY)
    found = {
        model.geom(g).name: model.mat(model.geom_matid[g]).name if model.geom_matid[g] >= 0 else None
        for g in range(model.ngeom)
    }
    limbs = {"trunk": "stage_dark", "pack": "stage_dark", "arm": "stage_light"}
    assert found == limbs | {
        "ground": "stage_floor", "post": "stage_step", "red": "own", "hull": None, "green": None
    }  # fmt: skip
    again = compose(compose(spec_of(GREY)).spec()).model()
    np.testing.assert_array_equal(again.geom_matid, model.geom_matid)


def test_a_class_that_gives_up_a_material_which_is_not_there_is_read_again():
    """MuJoCo takes such a model, and writes it without the material="" that saves it."""
    text = """<mujoco><default><default class="hidden"><geom material="glass"/>
      <default class="foot"><geom material="" size=".1"/></default></default></default>
      <worldbody><body><freejoint/><geom name="sole" class="foot"/></body></worldbody></mujoco>"""
    scene = compose(mujoco.MjSpec.from_string(text))
    again = mujoco.MjModel.from_xml_string(scene.mjcf, dict(scene.assets))
    assert again.geom("sole").size[0] == 0.1


ROOT = Path(__file__).parents[3]
LIGHTS = """<mujoco><worldbody><light directional="true"/><light/>
  <body><freejoint/><geom name="a" size=".1"/><body name="b"><geom size=".2"/></body></body></worldbody></mujoco>"""
FIELD = """<mujoco><asset><hfield name="h" nrow="3" ncol="2" size="1 1 1 1" elevation="0 .1 .2 .3 .4 1"/></asset>
  <worldbody><geom type="hfield" hfield="h"/></worldbody></mujoco>"""


def test_a_scenes_text_says_nothing_that_only_newer_versions_know():
    text = compose(figure_spec("human")).mjcf
    assert 'directional="true"' in text
    assert "colorspace" not in text
    assert not re.search(r"<light [^>]*type=", text)
    model = mujoco.MjModel.from_xml_string(text)
    assert [versions.lamp(model.light(i)) for i in range(model.nlight)] == ["directional"] * 2


def test_lamps_are_distinguished_and_elements_and_bodies_taken_out():
    spec = mujoco.MjSpec.from_string(LIGHTS)
    model = spec.compile()
    assert [versions.lamp(model.light(i)) for i in range(2)] == ["directional", "spot"]
    versions.remove(spec, spec.lights[0])
    versions.remove(spec, next(body for body in spec.bodies if body.name == "b"))
    model = spec.compile()
    assert (model.nlight, model.nbody, model.ngeom) == (1, 2, 1)


def test_a_height_field_is_written_as_it_is_read():
    spec = mujoco.MjSpec.from_string(FIELD)
    before = spec.compile().hfield_data
    again = mujoco.MjModel.from_xml_string(versions.portable_text(spec))
    np.testing.assert_allclose(again.hfield_data, before, atol=1e-6)


def test_the_oldest_that_ci_installs_are_the_oldest_that_the_package_allows():
    wanted = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["dependencies"]
    least = dict(re.match(r"([\w-]+)[^>]*>=([\w.]+)", each).groups() for each in wanted)  # type: ignore[union-attr]
    pinned = dict(re.findall(r"^([\w-]+)==([\w.]+)", (ROOT / ".ci" / "oldest.txt").read_text(), re.MULTILINE))
    assert {"mujoco", "numpy", "nlopt"} == pinned.keys()
    for name, version in pinned.items():
        assert version == least[name] or version.startswith(f"{least[name]}.")


def test_texts_have_the_digits_of_the_models_numbers():
    body = '<joint damping="0.123456789012"/><geom size=".1" mass="2.34567891"/>'
    text = f"<mujoco><worldbody><body>{body}</body></worldbody></mujoco>"
    spec = mujoco.MjSpec.from_string(text)
    spec.compile()
    assert 'damping="0.123456789012"' in versions.portable_text(spec) and 'size="0.1"' in versions.portable_text(spec)
    assert 'damping="0.123457"' in spec.to_xml()  # MuJoCo's setting is as before
