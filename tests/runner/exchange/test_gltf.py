"""glTF: what readers of others see is where MuJoCo has it, and Khronos' validator has nothing to say."""

from __future__ import annotations

import io
import json
import shutil
import subprocess

import motions
import numpy as np
import pytest
from oracles import kinematics

from dynsplines.exchange import formats
from dynsplines.exchange.skeleton import hierarchy
from dynsplines.motion import Sampled

pygltflib = pytest.importorskip("pygltflib")
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
    return pygltflib.GLTF2().load(str(target))


def accessor(asset, index):
    """An accessor's rows, read by hand from the format's own description."""
    found = asset.accessors[index]
    view = asset.bufferViews[found.bufferView]
    width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[found.type]
    kind = {5126: "<f4", 5123: "<u2", 5125: "<u4"}[found.componentType]
    start = (view.byteOffset or 0) + (found.byteOffset or 0)
    return np.frombuffer(asset.binary_blob(), kind, found.count * width, start).reshape(-1, width)


@pytest.mark.slow
def test_times_are_shared_exact_and_begin_at_zero(take, asset):
    (times,) = {sampler.input for sampler in asset.animations[0].samplers}
    np.testing.assert_array_equal(
        accessor(asset, times)[:, 0], (np.arange(len(take.time)) / take.fps).astype(np.float32)
    )
    assert asset.animations[0].extras["fps"] == take.fps
    assert len(asset.animations[0].extras["keyframes"]) == len(take.motion.keys)


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
    assert next(m for m in asset.materials if m.name == "glass").alphaMode == "BLEND"
