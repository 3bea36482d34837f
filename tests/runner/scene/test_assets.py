"""Models with files of meshes, images and height fields: a motion file holds all it takes to show them again."""

from pathlib import Path

import environment
import mujoco
import numpy as np
import pytest
from figures import stl
from PIL import Image
from texts import read_data

from dynsplines import motion, solving
from dynsplines.clip import load as clip
from dynsplines.errors import UserError
from dynsplines.exchange.motion_import import import_recording
from dynsplines.picture.show import Look, images
from dynsplines.scene.compose import compose, figure_spec

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


@pytest.mark.slow
def test_a_motion_file_needs_no_other_files(model):
    found = import_recording(model)
    target = model.parent.parent / "it.npz"
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
    scene = compose(figure_spec(str(model)))
    rest = np.tile(scene.model().qpos0, (2, 1))
    motion.save(solving.raw_spline(clip.from_qpos("it", scene, np.arange(2.0), rest, 30.0, "it")).motion, target)
    for damage in ("asset_0", "asset_names"):
        with np.load(target) as data:
            assert damage in data
            np.savez(bad, **{**data, damage: np.zeros(3)})  # type: ignore[arg-type]
        with pytest.raises(UserError, match="its arrays do not fit together"):
            motion.load(bad)
