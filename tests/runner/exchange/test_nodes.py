"""glTF and USD, read: bones are where the file's own matrices put them, and what this program wrote comes back."""

from __future__ import annotations

import avatar
import mujoco
import numpy as np
import pytest
import shipped
from oracles import kinematics
from scipy.spatial.transform import Rotation

from dynsplines import Keyframe, build, import_motion, inbetween
from dynsplines.edit import edits
from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.exchange.motion_import import import_recording
from dynsplines.exchange.nodes import gltf_file
from dynsplines.motion import sampled
from dynsplines.system.progress import Progress

gl = pytest.importorskip("pygltflib")
Gf, Usd, UsdGeom, UsdSkel, Vt = (
    pytest.importorskip(f"pxr.{name}") for name in ("Gf", "Usd", "UsdGeom", "UsdSkel", "Vt")
)
CLOSE = 2e-4  # [m]: files hold float32


class Glb:
    """A file with one buffer, written number by number."""

    def __init__(self) -> None:
        self.asset, self.data = gl.GLTF2(), b""

    def accessor(self, array: np.ndarray, kind: str) -> int:
        raw = np.ascontiguousarray(array, "<f4").tobytes()
        self.asset.bufferViews.append(gl.BufferView(buffer=0, byteOffset=len(self.data), byteLength=len(raw)))
        self.asset.accessors.append(
            gl.Accessor(bufferView=len(self.asset.bufferViews) - 1, componentType=5126, count=len(array), type=kind)
        )
        self.data += raw
        return len(self.asset.accessors) - 1

    def save(self, path):
        self.asset.buffers = [gl.Buffer(byteLength=len(self.data))]
        self.asset.set_binary_blob(self.data)
        path.write_bytes(b"".join(self.asset.save_to_bytes()))
        return path


def parts(matrices: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Translations, rotations xyzw and scales of matrices (..., 4, 4)."""
    size = np.linalg.norm(matrices[..., :3, :3], axis=-2)
    turns = matrices[..., :3, :3] / size[..., None, :]
    q = Rotation.from_matrix(turns.reshape(-1, 3, 3)).as_quat().reshape(*matrices.shape[:-2], 4)
    if q.ndim == 2:
        for i in range(1, len(q)):
            q[i] *= np.sign(q[i] @ q[i - 1])
    return matrices[..., :3, 3], q, size


def glb(path, *, interpolation: str = "LINEAR", skinned: bool = True, more: int = 0):
    """The avatar; its nodes stand in the first sample of the motion, so that a skin alone has the bind pose."""
    file, moving = Glb(), avatar.local(avatar.moving())
    start = moving[0] if skinned else avatar.local(avatar.bind())
    place, turn, size = parts(start)
    over = parts(avatar.armature()[None])
    file.asset.nodes = [gl.Node(name="Armature", rotation=over[1][0].tolist(), scale=over[2][0].tolist(), children=[1])]
    for i, name in enumerate(avatar.NAMES):
        below = [1 + k for k, parent in enumerate(avatar.PARENTS) if parent == i]
        node = {"translation": place[i].tolist(), "rotation": turn[i].tolist(), "scale": size[i].tolist()}
        file.asset.nodes.append(gl.Node(name=name, children=below, **node))
    file.asset.nodes.append(gl.Node(name="Floor"))
    file.asset.scenes, file.asset.scene = [gl.Scene(nodes=[0, len(file.asset.nodes) - 1])], 0
    if skinned:
        inverse = np.linalg.inv(avatar.bind()).swapaxes(1, 2).reshape(-1, 16)
        joints = list(range(1, 1 + len(avatar.NAMES)))
        file.asset.skins = [gl.Skin(joints=joints, inverseBindMatrices=file.accessor(inverse, "MAT4"))]
    times = file.accessor(np.arange(avatar.SAMPLES)[:, None] / avatar.FPS, "SCALAR")
    animation = gl.Animation(name="walk")
    for i in range(len(avatar.NAMES)):
        place, turn, _ = parts(moving[:, i])
        for target, values, kind in (("translation", place, "VEC3"), ("rotation", turn, "VEC4")):
            if interpolation == "CUBICSPLINE":
                slopes = avatar.FPS * np.gradient(values, axis=0)
                values = np.stack([slopes, values, slopes], axis=1).reshape(-1, values.shape[1])
            sampler = gl.AnimationSampler(input=times, output=file.accessor(values, kind), interpolation=interpolation)
            animation.samplers.append(sampler)
            animation.channels.append(
                gl.AnimationChannel(
                    sampler=len(animation.samplers) - 1, target=gl.AnimationChannelTarget(node=1 + i, path=target)
                )
            )
    file.asset.animations = [animation, *(gl.Animation(name=f"other {k}") for k in range(more))]
    return file.save(path)


def usd(path, *, up: str = "Y", unit: float = 1.0):
    """The avatar as a UsdSkel skeleton; with z up its world is turned, with another unit its numbers are larger."""
    turned = np.eye(4)
    if up == "Z":
        turned[:3, :3] = np.roll(np.eye(3), 1, axis=0)  # y up, facing z, to z up, facing x
    moving, bind = turned @ avatar.moving(), turned @ avatar.bind()
    for matrices in (moving, bind):
        matrices[..., :3, 3] /= unit
    stage = Usd.Stage.CreateNew(str(path))
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z if up == "Z" else UsdGeom.Tokens.y)
    UsdGeom.SetStageMetersPerUnit(stage, unit)
    stage.SetTimeCodesPerSecond(avatar.FPS)
    UsdSkel.Root.Define(stage, "/avatar")
    skeleton = UsdSkel.Skeleton.Define(stage, "/avatar/skeleton")
    paths: list[str] = []
    for name, parent in zip(avatar.NAMES, avatar.PARENTS, strict=True):
        paths.append(name if parent < 0 else f"{paths[parent]}/{name}")
    skeleton.CreateJointsAttr(paths)
    skeleton.CreateBindTransformsAttr(Vt.Matrix4dArray([Gf.Matrix4d(*m.T.ravel().tolist()) for m in bind]))
    rest = _relative(bind)
    skeleton.CreateRestTransformsAttr(Vt.Matrix4dArray([Gf.Matrix4d(*m.T.ravel().tolist()) for m in rest]))
    animation = UsdSkel.Animation.Define(stage, "/avatar/walk")
    animation.CreateJointsAttr(paths)
    channels = animation.CreateTranslationsAttr(), animation.CreateRotationsAttr(), animation.CreateScalesAttr()
    for code, pose in enumerate(_relative(moving)):
        place, turn, size = parts(pose[:, None])
        channels[0].Set(Vt.Vec3fArray([Gf.Vec3f(*row.tolist()) for row in place[:, 0]]), code)
        channels[1].Set(Vt.QuatfArray([Gf.Quatf(*np.roll(row, 1).tolist()) for row in turn[:, 0]]), code)
        channels[2].Set(Vt.Vec3hArray([Gf.Vec3h(*row.tolist()) for row in size[:, 0]]), code)
    UsdSkel.BindingAPI.Apply(skeleton.GetPrim()).CreateAnimationSourceRel().SetTargets(["/avatar/walk"])
    stage.Save()
    return path


def _relative(world: np.ndarray) -> np.ndarray:
    """(..., J, 4, 4) in the parents' axes."""
    out = world.copy()
    for i, parent in enumerate(avatar.PARENTS):
        if parent >= 0:
            out[..., i, :, :] = np.linalg.inv(world[..., parent, :, :]) @ world[..., i, :, :]
    return out


def places(saved, names: list[str]) -> np.ndarray:
    """(T, J, 3) [m] of bodies by MuJoCo."""
    bodies = [saved.figure.model.body(name).id for name in names]
    samples = sampled(saved.figure, saved.timeline, saved.fps)
    return np.array([kinematics(saved.figure.model, qpos).xpos[bodies] for qpos in samples.qpos])


FILES = {
    "linear.glb": glb,
    "cubic.glb": lambda path: glb(path, interpolation="CUBICSPLINE"),
    "steps.glb": lambda path: glb(path, interpolation="STEP"),
    "without_a_skin.vrm": lambda path: glb(path, skinned=False),
    "y_up.usda": usd,
    "z_up.usdc": lambda path: usd(path, up="Z"),
    "centimetres.usda": lambda path: usd(path, unit=0.01),
}


@pytest.mark.parametrize("name", FILES)
def test_bones_are_where_the_files_matrices_put_them(name, tmp_path):
    """All bones of the figure that comes with the file; it may be lifted as a whole."""
    saved = import_recording(FILES[name](tmp_path / name), progress=Progress())
    wanted = avatar.in_our_axes(avatar.moving())
    found = places(saved, avatar.NAMES)
    found[..., 2] += wanted[0, 0, 2] - found[0, 0, 2]
    assert found.shape == wanted.shape
    np.testing.assert_allclose(found, wanted, atol=CLOSE)


@pytest.mark.parametrize("ending", ["glb", "usdc"])
def test_a_motion_written_by_this_program_comes_back(ending, tmp_path):
    """Joints to the precision of the file; the root is placed on the ground, so it may be lifted as a whole."""
    whole = shipped.unsolved("hand_on_rail")
    written = edits.trimmed(whole, 0.6, 1.0)
    file = formats.export(written, "gltf" if ending == "glb" else "usd", tmp_path / f"a.{ending}")
    back = import_recording(file, figure="human", progress=Progress())
    wanted = sampled(written.figure, written.timeline, written.fps).qpos
    found = sampled(back.figure, back.timeline, written.fps).qpos
    found[:, 2] += wanted[0, 2] - found[0, 2]
    np.testing.assert_allclose(found[: len(wanted)], wanted, atol=1e-6)


def test_the_first_of_several_animations_is_read_and_named(tmp_path):
    file = glb(tmp_path / "a.glb", more=2)
    found = formats.recording(file)
    assert any("read 'walk', the first of 3 animations: walk, other 0, other 1" in note for note in found.notes)


def test_other_files_are_not_read(tmp_path):
    file = Glb()
    file.asset.animations = [gl.Animation()]
    file.save(tmp_path / "a.glb")
    text = tmp_path / "b.gltf"
    file.asset.buffers = [gl.Buffer(byteLength=4, uri="/etc/hostname")]
    text.write_text(file.asset.to_json(), encoding="utf-8")
    with pytest.raises(UserError, match=r"refers to another file, '/etc/hostname'; convert it to one \.glb"):
        formats.recording(text)
    stage = tmp_path / "b.usda"
    stage.write_text("#usda 1.0\n(\n    subLayers = [@/etc/other.usda@]\n)\n", encoding="utf-8")
    with pytest.raises(UserError, match=r"refers to another file, '/etc/other.usda'; flatten it"):
        formats.recording(stage)


@pytest.mark.parametrize(("rate", "last"), [(50.0, 65), (120.0, 7), (30.0, 49), (100.0, 6000), (24.0, 3001)])
def test_times_in_float32_lose_no_sample_and_no_rate(rate, last, tmp_path):
    file = Glb()
    file.asset.nodes = [gl.Node(name="a", children=[1]), gl.Node(name="b", translation=[0, 1, 0])]
    file.asset.scenes, file.asset.scene = [gl.Scene(nodes=[0])], 0
    times = np.arange(last + 1)[:, None] / rate
    values = np.hstack([np.sin(times), times, 0 * times])
    sampler = gl.AnimationSampler(input=file.accessor(times, "SCALAR"), output=file.accessor(values, "VEC3"))
    channel = gl.AnimationChannel(sampler=0, target=gl.AnimationChannelTarget(node=0, path="translation"))
    file.asset.animations = [gl.Animation(samplers=[sampler], channels=[channel])]
    skeleton = gltf_file.read(file.save(tmp_path / "a.glb"), None)
    assert (skeleton.fps, len(skeleton.local[0])) == (rate, last + 1)


CHAIN = """<mujoco><worldbody><body name="a" pos="0 0 1"><joint name="a" axis="0 0 1"/><geom size=".05"/>
<body name="b" pos=".3 0 0"><joint name="b" axis="0 1 0"/><geom size=".05"/>
<body name="c" pos=".3 0 0"><joint name="c" type="ball"/><geom size=".05"/><site pos=".3 0 0"/></body></body></body>
</worldbody></mujoco>"""


@pytest.mark.parametrize(("root", "length"), [("hinge", 0.3), ("free", 0.3), ("free", 0.03), ("hinge", 4)])
@pytest.mark.parametrize("ending", ["glb", "usdc"])
def test_the_joints_of_a_chain_come_back_in_metres(ending, root, length, tmp_path):
    text = CHAIN.replace('<joint name="a" axis="0 0 1"/>', "<freejoint/>") if root == "free" else CHAIN
    text = text.replace(".3 0 0", f"{length} 0 0")
    start = mujoco.MjModel.from_xml_string(text).qpos0
    turned = start + np.linspace(0.1, 0.5, start.size)
    arm = inbetween(build(text, [Keyframe(0, qpos=start), Keyframe(1, qpos=turned)]))
    back = import_motion(arm.export(tmp_path / f"arm.{ending}", fps=30))
    assert [back.model.body(i).name for i in range(1, back.model.nbody)] == ["a", "b", "c"]
    for time in np.arange(31) / 30:
        places = []
        for each in (arm, back):
            data = kinematics(each.model, each.at(time))
            places.append(data.xpos[1:].copy())
        np.testing.assert_allclose(places[1], places[0], atol=CLOSE)


@pytest.mark.parametrize("name", ["a.glb", "a.gltf", "a.usda", "a.usdc"])
def test_a_damaged_file_is_refused_in_a_line(name, tmp_path):
    path = tmp_path / name
    path.write_bytes(b"glTF\x02\0\0\0\xff\xff\xff\x7fgarbage")
    with pytest.raises(UserError, match=name):
        formats.recording(path)


def test_a_file_in_which_nothing_moves_is_refused(tmp_path):
    Glb().save(tmp_path / "a.glb")
    with pytest.raises(UserError, match="it holds no animation"):
        formats.recording(tmp_path / "a.glb")
    (tmp_path / "a.usda").write_text('#usda 1.0\n\ndef Xform "box"\n{\n}\n', encoding="utf-8")
    with pytest.raises(UserError, match="nothing moves on its stage"):
        formats.recording(tmp_path / "a.usda")
