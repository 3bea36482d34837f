"""MuJoCo from 3.3 on: what its versions call by other names, texts that all of them read, and what CI pins."""

import re
import tomllib
from pathlib import Path

import mujoco
import numpy as np

from dynsplines.scene import mujoco_versions as versions
from dynsplines.scene.compose import compose, figure_spec

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
