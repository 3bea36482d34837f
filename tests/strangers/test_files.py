"""Files that strangers send: they write nowhere but where they are asked to, and read nothing that is not theirs."""

import os
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path, PurePosixPath
from typing import Any

import motions
import mujoco
import numpy as np
import pytest
from figures import stl
from processes import Command

import dynsplines
from dynsplines import cli, motion
from dynsplines.batch import inputs
from dynsplines.batch import solving as batch_solving
from dynsplines.batch.inputs import InputSource
from dynsplines.batch.manifest import Manifest, check_below
from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.motion import Saved
from dynsplines.scene import file_access
from dynsplines.scene.assets import Scene
from dynsplines.scene.compose import compose, figure_spec

POSIX = pytest.mark.skipif(os.name == "nt", reason="needs POSIX links")
MODEL = """<mujoco><compiler meshdir="{folder}"/>{more}<asset>{asset}</asset><worldbody>
  <body name="trunk" pos="0 0 1"><freejoint name="root"/><geom size=".1"/><geom type="mesh" mesh="bone"/></body>
</worldbody></mujoco>"""
BONE = '<mesh file="bone.stl"/>'
Run = Callable[..., tuple[int, str]]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: Command) -> Run:
    """The command in a folder of its own, below the test's: its exit code and its last line on stderr."""
    (tmp_path / "here").mkdir(exist_ok=True)
    monkeypatch.chdir(tmp_path / "here")
    monkeypatch.setenv("MUJOCO_GL", "disable")  # so that it is put back

    def run(*words: object) -> tuple[int, str]:
        done = command(*words)
        return done.code, done.last

    return run


def model(folder: Path, *, asset: str = BONE, more: str = "", meshes: str = "meshes") -> Path:
    """A model in a folder, with a mesh below it."""
    (folder / "meshes").mkdir(parents=True)
    (folder / "meshes" / "bone.stl").write_bytes(stl(0.1))
    path = folder / "it.xml"
    path.write_text(MODEL.format(asset=asset, more=more, folder=meshes), encoding="utf-8")
    return path


def tree(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.fixture
def meshed(tmp_path: Path) -> Saved:
    """A motion that brings a mesh along."""
    keys = np.array([[0.0, 0, 1, 1, 0, 0, 0], [0.5, 0, 1, 1, 0, 0, 0]])
    return motions.through(str(model(tmp_path / "model")), np.array([0, 0.6]), keys)


def tampered(saved: Saved, target: Path, **changes: Any) -> Path:
    """A motion's file with other arrays in it; `mjcf` is a table of what is put for what."""
    motion.save(saved, target)
    with np.load(target) as data:
        arrays = {name: data[name] for name in data.files}
    said = changes.pop("mjcf", {})
    assert isinstance(said, Mapping)
    for old, new in said.items():
        assert old in str(arrays["mjcf"])
        arrays["mjcf"] = np.array(str(arrays["mjcf"]).replace(old, new))
    np.savez(target, **{**arrays, **changes})  # type: ignore[arg-type]
    return target


# names of files in motions


@pytest.mark.parametrize(
    ("to", "name"),
    [("thin", "/{there}/prey.stl"), ("mjcf", "sub/../../prey.stl"), ("gmr", "C:prey.stl"), ("thin", "a\\prey.stl")],
)
def test_a_motion_writes_no_file_that_its_names_lead_to(run: Run, meshed: Saved, tmp_path: Path, to: str, name: str):
    (tmp_path / "prey.stl").write_bytes(b"before")
    (tmp_path / "here" / "sub").mkdir()
    name = name.format(there=tmp_path.as_posix().strip("/"))
    tampered(meshed, tmp_path / "here" / "evil.npz", asset_names=np.array([name]), mjcf={'"bone.stl"': f'"{name}"'})
    before = tree(tmp_path)
    words = ("thin", "evil.npz", "-o", "x.toml") if to == "thin" else ("export", "evil.npz", "--to", to)
    code, said = run(*words, "--overwrite")
    assert code == 2
    assert "evil.npz" in said and ("not a plain file name" in said or "does not bring along" in said)
    assert tree(tmp_path) == before


@pytest.mark.parametrize("name", ["../x.stl", "/x.stl", "a/b.stl", ".x", "a\nb", "nul\0", "x" * 300])
def test_a_scene_has_plain_names_wherever_it_comes_from(name: str):
    with pytest.raises(ValueError, match="not a plain file name"):
        Scene("<mujoco/>", {name: b""})
    assert Scene("<mujoco/>", {"Größe 2.stl": b""}).assets


@pytest.mark.parametrize(
    "said",
    [
        {'file="bone.stl"': 'file="/etc/passwd"'},
        {'file="bone.stl"': 'file="&#47;etc/passwd"'},
        {"<worldbody>": '<include file="../secret.xml"/><worldbody>'},
        {"<worldbody>": '<compiler meshdir="/etc"/><worldbody>'},
        {"<worldbody>": '<asset><model name="m" file="/x.xml"/></asset><worldbody>'},
    ],
)
def test_a_motion_reads_no_file_next_to_its_own(meshed: Saved, tmp_path: Path, said: Mapping[str, str]):
    with pytest.raises(UserError, match=r"evil\.npz: .*(bring|include)"):
        motion.load(tampered(meshed, tmp_path / "evil.npz", mjcf=said))


def test_a_recording_that_brings_its_figure_reads_no_file_next_to_its_own(meshed: Saved, tmp_path: Path):
    target = tmp_path / "it.qpos.npz"
    formats.export(meshed, "npz", target)
    with np.load(target) as data:
        arrays = {name: data[name] for name in data.files}
    secret = tmp_path / "secret.stl"
    secret.write_bytes(stl(0.3))
    other = str(arrays["mjcf"]).replace('"bone.stl"', f'"{secret.as_posix()}"')
    np.savez(target, **{**arrays, "mjcf": np.array(other)})  # type: ignore[arg-type]
    with pytest.raises(UserError, match=r"refers to '.*secret\.stl', which it does not bring along"):
        dynsplines.import_motion(target)


def test_a_motions_own_name_leads_to_no_other_folder(meshed: Saved, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    assert formats.export(replace(meshed, name="../prey"), "csv") == Path("prey.csv")
    assert formats.export(replace(meshed, name=str(tmp_path / "prey")), "csv") == Path("prey.csv")
    assert [path.name for path in (tmp_path / "here").iterdir()] == ["prey.csv"]


@pytest.mark.parametrize("name", ["x.toml", "x.xml"])
def test_a_figures_file_does_not_take_the_clips_place(meshed: Saved, tmp_path: Path, name: str):
    scene = Scene(meshed.mjcf.replace('"bone.stl"', f'"{name}"'), {name: stl(0.1)})
    with pytest.raises(UserError, match="choose another name"):
        dynsplines.Motion(replace(meshed, scene=scene)).save(tmp_path / "x.toml", overwrite=True)


# files that models name


def clip_of(path: Path) -> Path:
    """A clip of a model, beside it."""
    rows = "".join(f'[[keyframe]]\ntime = {t}\nothers = "rest"\n' for t in (0, 1))
    clip = path.with_suffix(".toml")
    clip.write_text(f'figure = "{path.name}"\n{rows}', encoding="utf-8")
    return clip


def outsiders(folder: Path) -> dict[str, Path]:
    """Models with a file outside their folder, each in its own way."""
    folder.mkdir(exist_ok=True)
    secret = folder / "secret.stl"
    secret.write_bytes(stl(0.3))
    (folder / "secret.xml").write_text("<mujoco><asset><mesh file='bone.stl'/></asset></mujoco>", encoding="utf-8")
    mesh = '<mesh name="bone" file="{}"/>'
    found = {
        "absolute": model(folder / "absolute", asset=mesh.format(secret.as_posix())),
        "up": model(folder / "up", asset=mesh.format("../../secret.stl")),
        "folder": model(folder / "folder", asset=mesh.format("secret.stl"), meshes=".."),
        "include": model(folder / "include", asset="", more='<include file="../secret.xml"/>'),
        "odd": model(folder / "odd", asset="", more=f'<include file="&#46;./secret.xml"/><a{" b=" * 2}>'),
        "submodel": model(folder / "submodel", more='<asset><model name="m" file="sub/arm.xml"/></asset>', asset=BONE),
    }
    (folder / "submodel" / "sub").mkdir()
    (folder / "submodel" / "sub" / "arm.xml").write_text(
        "<mujoco><include file='../../secret.xml'/><worldbody><body name='arm'/></worldbody></mujoco>"
    )
    if os.name != "nt":
        found["link"] = model(folder / "link", asset=mesh.format("link.stl"))
        (folder / "link" / "meshes" / "link.stl").symlink_to(secret)
    return found


@POSIX
@pytest.mark.parametrize("way", ["absolute", "up", "folder", "include", "odd", "submodel", "link"])
def test_models_and_batches_read_nothing_outside_a_models_folder_unless_they_may(tmp_path: Path, way: str):
    path = outsiders(tmp_path)[way]
    clip = clip_of(path)
    with pytest.raises(UserError, match=r"secret.*outside its folder '.*'; .*--allow-outside") as caught:
        dynsplines.load(clip)
    assert str(path.parent) in str(caught.value)
    with pytest.raises(UserError, match=r"secret.*outside its folder"):
        inputs.task_of(InputSource(clip, PurePosixPath("it")), {})
    with file_access.allow():
        packed = inputs.task_of(InputSource(clip, PurePosixPath("it")), {}).files
    assert any("secret" in name or "link" in name for name in packed)
    if way not in ("odd", "submodel"):  # which are no models that MuJoCo reads
        assert dynsplines.load(clip, allow_outside=True).figure.model.nmesh == 1
        with pytest.raises(UserError, match="outside its folder"):
            dynsplines.load(clip)


@POSIX
def test_a_spec_given_from_python_is_held_to_the_same(tmp_path: Path):
    path = outsiders(tmp_path)["up"]
    keys = [dynsplines.Keyframe(0.0, others="rest"), dynsplines.Keyframe(0.5, others="rest")]
    for figure in (path, mujoco.MjSpec.from_file(str(path))):
        with pytest.raises(UserError, match="outside its folder"):
            dynsplines.build(figure, keys)
        assert dynsplines.build(figure, keys, allow_outside=True).scene.assets


@pytest.mark.slow
@POSIX
def test_the_option_counts_for_its_command_alone(run: Run, tmp_path: Path):
    path = outsiders(tmp_path / "models")["absolute"]
    code, said = run("new", path, "-o", "a.toml")
    assert code == 2 and "secret.stl', outside its folder" in said
    assert run("new", path, "-o", "a.toml", "--allow-outside")[0] == 0
    code, said = run("solve", "a.toml")
    assert code == 2 and "--allow-outside" in said
    assert not file_access.is_allowed()
    assert run("solve", "a.toml", "--allow-outside")[0] == 0
    assert run("thin", "a.npz", "-o", "b.toml")[0] == 0  # a motion has its files in it


def test_every_command_that_reads_models_has_the_option():
    words = ("render", "solve", "report", "plot", "new", "mirror", "retime", "trim", "thin", "export", "clean")
    having = {
        command.name or command.callback.__name__
        for command in cli.app.registered_commands
        if command.callback is not None and "allow_outside" in command.callback.__annotations__
    }
    assert having == {*words, "import", "batch", "retarget", "studio"}


@POSIX
def test_a_batch_that_may_read_outside_solves_elsewhere_too(tmp_path: Path):
    path = outsiders(tmp_path / "here")["up"]
    with file_access.allow():
        files = inputs.task_of(InputSource(clip_of(path), PurePosixPath("it")), {})
    (tmp_path / "there").mkdir()
    done = batch_solving.solve(replace(files, output="it.npz", allow_outside=True), tmp_path / "there")
    (tmp_path / "it.npz").write_bytes(done.files["it.npz"])
    assert motion.load(tmp_path / "it.npz").scene.assets == {"secret.stl": stl(0.3)}


ARM = """<mujoco model="arm"><compiler meshdir="{folder}"/><asset><mesh file="bone.stl"/></asset>
<worldbody><body name="{name}"><joint/><geom type="mesh" mesh="bone"/></body></worldbody></mujoco>"""


def attaching(folder: Path, size: float) -> Path:
    """A model with a mesh that attaches two with meshes of the same name and that size."""
    brought, attached = "", ""
    for name, meshes in (("arm", "meshes"), ("leg", "parts")):
        (folder / name / meshes).mkdir(parents=True)
        (folder / name / meshes / "bone.stl").write_bytes(stl(size if name == "arm" else 0.3))
        (folder / name / "it.xml").write_text(ARM.format(folder=meshes, name=name), encoding="utf-8")
        brought += f'<model name="{name}" file="{name}/it.xml"/>'
        attached += f'<attach model="{name}" body="{name}" prefix="{name}_"/>'
    path = model(folder / "whole", asset=BONE + brought)
    text = path.read_text(encoding="utf-8").replace("</body>", f"{attached}</body>")
    text = text.replace(' 1 0 0 0"', ' 1 0 0 0 0 0"')
    (folder / "whole.xml").write_text(text.replace('meshdir="meshes"', 'meshdir="whole/meshes"'), encoding="utf-8")
    return folder / "whole.xml"


def test_models_that_are_attached_bring_their_meshes_from_below(tmp_path: Path):
    path = attaching(tmp_path / "model", 0.2)
    scene = compose(figure_spec(str(path)))
    assert sorted(scene.assets.values()) == sorted(map(stl, (0.1, 0.2, 0.3)))
    before, after = mujoco.MjModel.from_xml_path(str(path)), scene.model()
    np.testing.assert_allclose(np.sort(after.mesh_vert, axis=0), np.sort(before.mesh_vert, axis=0), atol=1e-7)


# manifests that strangers send


@POSIX
def test_a_link_in_a_batchs_folder_leads_no_output_out_of_it(tmp_path: Path):
    out, prey = tmp_path / "out", tmp_path / "prey"
    out.mkdir()
    prey.write_bytes(b"before")
    for name in ("walk.npz", "manifest.jsonl"):
        (out / name).symlink_to(prey)
    (out / "sub").symlink_to(tmp_path)
    for name in ("walk.npz", "sub/prey"):
        with pytest.raises(UserError, match=r"leads out of the folder, to '.*prey'; remove the link"):
            check_below(out, name)
    check_below(out, "walk/run.npz")
    with pytest.raises(UserError, match="leads out of the folder"):
        Manifest.of(out)
    assert prey.read_bytes() == b"before"
