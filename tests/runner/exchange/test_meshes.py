"""Figures with meshes: the files that a model refers to lie beside what is written, or in it, and come back."""

import mujoco
import numpy as np
import pytest
import wild

from dynsplines.exchange import formats
from dynsplines.exchange.motion_import import import_recording

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
