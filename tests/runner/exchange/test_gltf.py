"""glTF: what readers of others see is where MuJoCo has it, and Khronos' validator has nothing to say."""

import io
import json
import shutil
import struct
import subprocess

import motions
import numpy as np
import pytest
from oracles import kinematics
from scipy.spatial.transform import Rotation

from dynsplines.exchange import formats
from dynsplines.exchange.skeleton import hierarchy
from dynsplines.motion import Sampled

trimesh = pytest.importorskip("trimesh")

VALIDATE = """
require('gltf-validator').validateBytes(new Uint8Array(require('fs').readFileSync(process.argv[1])))
.then(found => console.log(JSON.stringify(found.issues)))
"""


@pytest.fixture(scope="module")
def take():
    return Sampled.of(motions.moved(), 48.0)


@pytest.fixture(scope="module")
def target(take, tmp_path_factory):
    return formats.export(take.motion, "gltf", tmp_path_factory.mktemp("gltf") / "a.glb", fps=take.fps)


@pytest.fixture(scope="module")
def asset(target):
    """The file's JSON as objects, with its buffer, read by hand from the format's own description."""
    content = target.read_bytes()
    (length,) = struct.unpack("<I", content[12:16])
    asset = json.loads(content[20 : 20 + length], object_hook=Part)
    asset["buffer"] = content[28 + length :]
    return asset


class Part(dict):
    """An object of the JSON whose absent members are None."""

    __getattr__ = dict.get


def accessor(asset, index):
    """The rows of an accessor."""
    rows = asset.accessors[index]
    view = asset.bufferViews[rows.bufferView]
    width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[rows.type]
    kind = {5126: "<f4", 5123: "<u2", 5125: "<u4"}[rows.componentType]
    start = (view.byteOffset or 0) + (rows.byteOffset or 0)
    return np.frombuffer(asset.buffer, kind, rows.count * width, start).reshape(-1, width)


@pytest.mark.slow
def test_times_are_shared_exact_and_begin_at_zero(take, asset):
    (times,) = {sampler.input for sampler in asset.animations[0].samplers}
    np.testing.assert_array_equal(
        accessor(asset, times)[:, 0], (np.arange(len(take.time)) / take.fps).astype(np.float32)
    )
    assert asset.animations[0].extras.fps == take.fps
    keys = [key.time - take.time[0] for key in take.motion.keys]
    np.testing.assert_allclose(asset.animations[0].extras.keyframes, keys, atol=1e-9)
    first, last = asset.accessors[times].min, asset.accessors[times].max
    assert (*first, *last) == pytest.approx((0, take.time[-1] - take.time[0]))


@pytest.mark.slow
def test_every_body_is_where_mujoco_has_it_at_every_sample_and_what_stays_has_no_channel(take, asset):
    """By SciPy's rotations, from the nodes' own places and from the channels, with x to the front and y up."""
    tracks = {}
    for channel in asset.animations[0].channels:
        track = accessor(asset, asset.animations[0].samplers[channel.sampler].output)
        assert np.ptp(track, axis=0).max() > 0
        tracks[channel.target.node, channel.target.path] = track
    count, nodes = len(take.time), asset.nodes
    above = {child: parent for parent, node in enumerate(nodes) for child in node.children or []}
    world = {}
    for body, node in enumerate(nodes):
        place = tracks.get((body, "translation"), np.tile(node.translation, (count, 1)))
        turn = Rotation.from_quat(tracks.get((body, "rotation"), np.tile(node.rotation, (count, 1))))
        if body in above:
            from_place, from_turn = world[above[body]]
            place, turn = from_place + from_turn.apply(place), from_turn * turn
        world[body] = place, turn
    for sample in (0, count // 2, count - 1):
        data = kinematics(take.model, take.qpos[sample])
        for body, (place, turn) in world.items():
            np.testing.assert_allclose(np.roll(place[sample], 1), data.xpos[body], atol=1e-5)
            axes = np.roll(turn[sample].as_matrix(), 1, axis=0)
            np.testing.assert_allclose(axes, data.xmat[body].reshape(3, 3), atol=1e-5)


def test_a_file_has_its_own_length_and_parts_of_whole_words(target, asset):
    content = target.read_bytes()
    assert struct.unpack("<4sII", content[:12]) == (b"glTF", 2, len(content))
    start, sizes = 12, []
    while start < len(content):
        sizes.append(struct.unpack("<I", content[start : start + 4])[0])
        start += 8 + sizes[-1]
    assert start == len(content)
    assert all(size % 4 == 0 for size in sizes)
    assert sizes[1] == asset.buffers[0].byteLength
    assert all(view.byteOffset % 4 == 0 for view in asset.bufferViews)


@pytest.mark.slow
def test_rotations_are_unit_and_stay_on_their_hemisphere(asset):
    for channel in asset.animations[0].channels:
        if channel.target.path == "rotation":
            track = accessor(asset, asset.animations[0].samplers[channel.sampler].output).astype(float)
            np.testing.assert_allclose(np.linalg.norm(track, axis=1), 1, atol=1e-6)
            assert np.all(np.sum(track[1:] * track[:-1], axis=1) > 0)


@pytest.mark.slow
def test_another_reader_sees_the_visible_geoms_and_no_others(take, target, asset):
    """trimesh places the corners of a body's mesh, and MuJoCo its visible geoms, within the same spheres."""
    scene = trimesh.load_scene(io.BytesIO(target.read_bytes()), file_type="glb")
    data, names = kinematics(take.model, take.qpos[0]), hierarchy.names(take.model)
    meshes = {node.name: asset.meshes[node.mesh] for node in asset.nodes if node.mesh is not None}
    for body in range(1, take.model.nbody):
        geoms = np.flatnonzero((take.model.geom_bodyid == body) & (take.model.geom_group < 3))
        assert (names[body] in meshes) == bool(geoms.size)
        if not geoms.size:
            continue
        corners = np.concatenate([accessor(asset, p.attributes.POSITION) for p in meshes[names[body]].primitives])
        seen = np.roll(trimesh.transform_points(corners, scene.graph.get(names[body])[0]), 1, axis=1)
        away = np.linalg.norm(seen[:, None] - data.geom_xpos[geoms], axis=-1) - take.model.geom_rbound[geoms]
        assert away.min(axis=1).max() < 0.004, names[body]


@pytest.mark.slow
def test_faces_look_outwards(asset):
    """A mesh turned inside out has a negative volume, and normals against its faces."""
    for mesh in asset.meshes:
        for primitive in mesh.primitives:
            points, normals = (accessor(asset, getattr(primitive.attributes, k)) for k in ("POSITION", "NORMAL"))
            faces = accessor(asset, primitive.indices)[:, 0].reshape(-1, 3)
            a, b, c = (points[faces[:, k]].astype(float) for k in range(3))
            across = np.cross(b - a, c - a)
            assert np.all(np.sum(across * normals[faces].sum(axis=1), axis=1) > 0), mesh.name


@pytest.mark.slow
def test_khronos_validator_finds_neither_error_nor_warning(target):
    node = shutil.which("node")
    known = node and subprocess.run([node, "-e", "require('gltf-validator')"], capture_output=True).returncode == 0
    if not node or not known:
        pytest.skip("no node with gltf-validator; npm install gltf-validator, and NODE_PATH")
    done = subprocess.run([node, "-e", VALIDATE, str(target)], capture_output=True, text=True, check=True)
    issues = json.loads(done.stdout)
    assert (issues["numErrors"], issues["numWarnings"]) == (0, 0), issues["messages"]


@pytest.mark.slow
def test_colours_are_given_in_linear_light(asset, take):
    known = {material.name: material.pbrMetallicRoughness.baseColorFactor for material in asset.materials}
    rgb = np.array(take.model.mat("red").rgba[:3])
    np.testing.assert_allclose(known["red"][:3], ((rgb + 0.055) / 1.055) ** 2.4, atol=1e-6)
    glass = next(material for material in asset.materials if material.name == "glass")
    assert {material.name for material in asset.materials if material.alphaMode == "BLEND"} == {"glass"}
    assert glass.pbrMetallicRoughness.baseColorFactor[3] == pytest.approx(take.model.mat("glass").rgba[3])
    assert len(known) == len(asset.materials)  # of pieces that look alike, one
