"""MJCF with keys, read by MuJoCo and from other people's models, and the meshes that a model refers to."""

import mujoco
import numpy as np
import pytest
import tiny
import wild

from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.exchange.motion_import import import_recording


def test_mujoco_reads_every_key_to_the_last_digit(human, tmp_path):
    target = formats.export(human, "mjcf", tmp_path / "out.keys.xml")
    model, before = mujoco.MjModel.from_xml_path(str(target)), wild.samples(human)
    np.testing.assert_array_equal(model.key_time, before.time)
    np.testing.assert_allclose(model.key_qpos, before.qpos, atol=1e-15)  # quaternions are made unit once more
    np.testing.assert_array_equal(model.key_qvel, before.qvel)
    assert [model.key(i).name for i in (0, 60)] == ["wild_0", "wild_60"]
    for name in ("body_pos", "body_mass", "geom_size", "site_pos", "jnt_range"):
        np.testing.assert_array_equal(getattr(model, name), getattr(human.figure.model, name))
    wild.same_poses(model, before.qpos, model.key_qpos)


def test_keys_of_others_are_read_with_their_figure_and_faults_are_reported(tmp_path):
    def written(keys):
        (tmp_path / "own.xml").write_text(tiny.HINGE.format(keys=keys))
        return tmp_path / "own.xml"

    good = '<keyframe><key time="0" qpos="0 0"/><key time="0.5" qpos="0.1 1.2"/></keyframe>'
    back = import_recording(written(good))
    np.testing.assert_allclose(wild.samples(back).qpos[-1], [0.1, 1.2])
    with pytest.raises(UserError, match="no <key> elements; a motion needs two or more"):
        import_recording(written(""))
    with pytest.raises(UserError, match="all its keys are of the time 0"):
        import_recording(written(good.replace("0.5", "0")))
    with pytest.raises(UserError, match="its qpos has 2 numbers; the figure's 51"):
        import_recording(written(good), figure="human")
    with pytest.raises(UserError, match="MuJoCo cannot"):
        import_recording(written("<keyframe><key nonsense='1'/></keyframe>"))


TETRAHEDRON = "v 0 0 0\nv .1 0 0\nv 0 .12 0\nv 0 0 .3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
FIGURE = """
<mujoco><compiler meshdir="parts"/><asset><mesh name="trunk" file="trunk.obj"/></asset>
  <worldbody><body name="trunk" pos="0 0 1"><freejoint name="root"/><geom type="mesh" mesh="trunk"/>
    <body name="arm" pos="0 .2 0"><joint name="shoulder" type="ball"/><geom type="mesh" mesh="trunk"/></body></body>
  </worldbody></mujoco>"""


@pytest.fixture
def saved(tmp_path):
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "trunk.obj").write_text(TETRAHEDRON)
    (tmp_path / "figure.xml").write_text(FIGURE)
    out = wild.motion_of(str(tmp_path / "figure.xml"))
    (tmp_path / "parts" / "trunk.obj").unlink()  # from here on the motion brings it along
    return out


@pytest.mark.parametrize("kind", ["mjcf", "mjlab", "locomujoco", "gmr", "mimickit"])
def test_models_next_to_or_in_the_file_find_their_meshes(kind, saved, tmp_path):
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    notes = []
    formats.export(saved, kind, folder / f"out{formats.writer(kind).ending}", report=notes.append)
    assert f"wrote {folder / 'trunk.obj'}" in notes
    text = next(path for path in folder.iterdir() if path.suffix == ".xml")
    model = mujoco.MjModel.from_xml_path(str(text))
    np.testing.assert_array_equal(model.mesh_vert, saved.figure.model.mesh_vert)
    np.testing.assert_array_equal(model.body_mass, saved.figure.model.body_mass)


@pytest.mark.parametrize("kind", ["mjcf", "npz"])
def test_files_that_bring_a_figure_bring_its_meshes(kind, saved, tmp_path):
    back = import_recording(formats.export(saved, kind, tmp_path / f"out{formats.writer(kind).ending}"))
    assert back.figure.model.nmesh == 1
    before, after = wild.samples(saved), wild.samples(back)
    wild.same_poses(saved.figure.model, before.qpos, after.qpos)
