"""The nodes of a glTF 2.0 file that an animation moves; VRM avatars and Mixamo's exports are such files.

https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html, sections 3.6 (accessors), 3.7.3 (skins), 3.11 (animations).
The rest pose is the one to which a skin is bound, else that of the nodes without animation. References to other files
are refused.
"""

from __future__ import annotations

import base64
import binascii
from pathlib import Path
from typing import Any

import numpy as np
import pygltflib as gl
from scipy.interpolate import CubicHermiteSpline, make_interp_spline
from scipy.spatial.transform import Rotation, Slerp

from dynsplines.solver.array import Array, segments_at

from ...errors import UserError, listed, words_of
from ...system import size_limit
from .. import gaps
from ..skeleton.bvh_file import Skeleton
from .node_tree import Nodes, float32_step, moving_tree, rate_of

KINDS = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
PATHS = ("translation", "rotation", "scale")
EMBEDDED = "base64,"
REST = "rest"  # in extras of nodes written by this program: translation and rotation in the model's rest pose
SOON = 1e-6  # [s] tolerance before a key's time, which is rounded to float32
SINGULAR = 1e-12  # determinant below which a matrix counts as singular


def read(path: Path, fps: float | None) -> Skeleton:
    """Return the skeleton of the nodes that the first animation moves.

    fps [1/s] to resample, else the animation's rate. Raises UserError for a file without an animation, or with
    references to other files.
    """
    try:
        return _File(path).nodes(fps).skeleton()
    except UserError:
        raise
    except Exception as error:  # a damaged file raises nearly anything
        raise UserError(f"{path}: not a readable glTF file: {words_of(error)[:200]}") from None


class _File:
    """A file's nodes, with access to the data of its accessors."""

    def __init__(self, path: Path) -> None:
        data = path.read_bytes()
        asset = gl.GLTF2.load_from_bytes(data) if data[:4] == b"glTF" else gl.GLTF2.gltf_from_json(data.decode("utf-8"))
        if asset is None:
            raise UserError(f"{path}: not a glTF file")
        self.path, self.asset = path, asset
        self.buffers = [self._buffer(buffer) for buffer in asset.buffers]

    def _buffer(self, buffer: gl.Buffer) -> bytes:
        if buffer.uri is None:
            return self.asset.binary_blob() or b""
        if EMBEDDED not in buffer.uri[:100]:
            raise UserError(f"{self.path}: it refers to another file, '{buffer.uri[:80]}'; convert it to one .glb")
        try:
            return base64.b64decode(buffer.uri.partition(EMBEDDED)[2], validate=True)
        except binascii.Error:
            raise UserError(f"{self.path}: an embedded buffer is not base64") from None

    def rows(self, index: int) -> Array:
        """Return an accessor's numbers (n, width); normalised integers as fractions."""
        accessor = self.asset.accessors[index]
        if accessor.sparse is not None or accessor.bufferView is None:
            raise UserError(f"{self.path}: accessor {index} is sparse, which is not read")
        view, kind = self.asset.bufferViews[accessor.bufferView], np.dtype(KINDS[accessor.componentType])
        width, start = WIDTHS[accessor.type], (view.byteOffset or 0) + (accessor.byteOffset or 0)
        stride = view.byteStride or width * kind.itemsize
        size_limit.check(self.path, 8 * width * accessor.count, f"accessor {index}")
        data = self.buffers[view.buffer]
        if start < 0 or stride < 1 or start + stride * (accessor.count - 1) + width * kind.itemsize > len(data):
            raise UserError(f"{self.path}: accessor {index} reaches beyond its buffer; the file is cut short")
        raw = np.ndarray((accessor.count, width), kind, data, start, (stride, kind.itemsize))
        out = raw.astype(float)
        return np.maximum(out / np.iinfo(kind).max, -1) if accessor.normalized and kind.kind != "f" else out

    def nodes(self, fps: float | None) -> Nodes:
        """Return the moving nodes at equal time steps."""
        if not self.asset.animations or not self.asset.animations[0].channels:
            raise UserError(f"{self.path}: it holds no animation")
        animation = self.asset.animations[0]
        notes = self._choice()
        channels = [channel for channel in animation.channels if channel.target.path in PATHS]
        keys = [self.rows(animation.samplers[channel.sampler].input)[:, 0] for channel in channels]
        if not keys or max(times.size for times in keys) < gaps.FEWEST:
            raise UserError(f"{self.path}: its animation '{animation.name}' moves no node")
        first, last = min(float(times[0]) for times in keys), max(float(times[-1]) for times in keys)
        rate = fps or rate_of(max(keys, key=len))
        count = int((last - first + float32_step(np.array([first, last]))) * rate + 1e-6) + 1
        size_limit.check(self.path, 8 * 16 * count * len(self.asset.nodes), "its animation")
        at = first + np.arange(count) / rate
        order, parents = self._order()
        moved: dict[int, dict[str, Array]] = {}
        for channel in channels:
            values = self._sampled(animation.samplers[channel.sampler], channel.target.path, at)
            if channel.target.node is not None:
                moved.setdefault(channel.target.node, {})[channel.target.path] = values
        above = [order.index(parents[i]) if i in parents else -1 for i in order]
        rows, parents_of_rows = moving_tree(above, [i in moved for i in order])
        rest, world = self._placed(order, above, moved, count)
        names = [self.asset.nodes[order[row]].name or f"node_{order[row]}" for row in rows]
        return Nodes(names, parents_of_rows, rest[rows], world[:, rows], rate, notes)

    def _choice(self) -> tuple[str, ...]:
        names = [animation.name or f"animation {i}" for i, animation in enumerate(self.asset.animations)]
        if len(names) == 1:
            return ()
        return (f"read '{names[0]}', the first of {len(names)} animations: {listed(names, 8)}",)

    def _order(self) -> tuple[list[int], dict[int, int]]:
        count = len(self.asset.nodes)
        parents = {child: i for i, node in enumerate(self.asset.nodes) for child in node.children or ()}
        waiting = [i for i in reversed(range(count)) if i not in parents]
        order = list[int]()
        while waiting:
            node = waiting.pop()
            order.append(node)
            waiting += reversed(self.asset.nodes[node].children or [])
            if len(order) > count:
                break
        if len(order) != count or len(set(order)) != count:
            raise UserError(f"{self.path}: its nodes are not trees: some are their own ancestors, or have two parents")
        return order, parents

    def _placed(
        self, order: list[int], above: list[int], moved: dict[int, dict[str, Array]], count: int
    ) -> tuple[Array, Array]:
        """Return matrices (J, 4, 4) and (T, J, 4, 4) of nodes in the world, at rest and in motion."""
        bound = self._bound()
        rest, world = np.empty((len(order), 4, 4)), np.empty((count, len(order), 4, 4))
        for row, (index, parent) in enumerate(zip(order, above, strict=True)):
            node, over = self.asset.nodes[index], order[parent] if parent >= 0 else -1
            matrix = _matrix(node)
            still = np.linalg.inv(bound[over]) @ bound[index] if index in bound and over in bound else _at_rest(node)
            moving = (
                _composed(matrix, moved[index], count) if index in moved else np.broadcast_to(matrix, (count, 4, 4))
            )
            rest[row] = still if parent < 0 else rest[parent] @ still
            world[:, row] = moving if parent < 0 else world[:, parent] @ moving
        return rest, world

    def _bound(self) -> dict[int, Array]:
        """Return, by joint of the skins, its matrix in the mesh's axes when the mesh was bound to it."""
        out = dict[int, Array]()
        for skin in self.asset.skins:
            if skin.inverseBindMatrices is not None:
                inverse = self.rows(skin.inverseBindMatrices).reshape(-1, 4, 4).swapaxes(1, 2)
                for joint, matrix in zip(skin.joints or (), inverse, strict=False):
                    if joint not in out and abs(np.linalg.det(matrix)) > SINGULAR:
                        out[joint] = np.asarray(np.linalg.inv(matrix), float)
        return out

    def _sampled(self, sampler: gl.AnimationSampler, path: str, at: Array) -> Array:
        """Return a channel's values (T, 3 or 4) at times (T,), constant before its first key and after its last."""
        keys, values = self.rows(sampler.input)[:, 0], self.rows(sampler.output)
        at = np.clip(at, keys[0], keys[-1])
        if np.any(np.diff(keys) <= 0):
            raise UserError(f"{self.path}: the times of a channel do not rise")
        if sampler.interpolation == gl.ANIM_CUBICSPLINE:
            into, values, out = values.reshape(keys.size, 3, -1).swapaxes(0, 1)
            return _hermite(keys, values, into, out, at)
        if len(values) != keys.size:
            raise UserError(f"{self.path}: a channel has {keys.size} times and {len(values)} values")
        if sampler.interpolation == gl.ANIM_STEP or keys.size < gaps.FEWEST:
            return values[np.clip(np.searchsorted(keys, at + SOON, side="right") - 1, 0, keys.size - 1)]
        if path == "rotation":
            return Slerp(keys, Rotation.from_quat(values))(at).as_quat()
        return make_interp_spline(keys, values, k=1)(at)


def _hermite(keys: Array, values: Array, into: Array, out: Array, at: Array) -> Array:
    """Interpolate cubically between keys with separate slopes before and after each."""
    if keys.size < gaps.FEWEST:
        return np.repeat(values, at.size, axis=0)
    span = segments_at(keys, at)
    samples = np.empty((at.size, values.shape[1]))
    for i in np.unique(span):
        ends, here = slice(i, i + 2), span == i
        slopes = np.stack([out[i], into[i + 1]])
        samples[here] = CubicHermiteSpline(keys[ends], values[ends], slopes)(at[here])
    return samples


def _at_rest(node: Any) -> Array:
    """Return the matrix (4, 4) of a node in the rest pose of its extras, else without animation."""
    rest = (node.extras or {}).get(REST)
    if not isinstance(rest, dict):
        return _matrix(node)
    return _composed(np.eye(4), {path: np.array([rest[path]], float) for path in PATHS if path in rest}, 1)[0]


def _matrix(node: Any) -> Array:
    """Return the matrix (4, 4) of a node without animation."""
    if node.matrix:
        return np.array(node.matrix, float).reshape(4, 4).T
    return _composed(np.eye(4), {p: np.array([getattr(node, p)], float) for p in PATHS if getattr(node, p)}, 1)[0]


def _composed(still: Array, parts: dict[str, Array], count: int) -> Array:
    """Return matrices (T, 4, 4) from translations, rotations xyzw and scales (T, ...), by default those of `still`."""
    size = np.linalg.norm(still[:3, :3], axis=0)
    out = np.tile(still, (count, 1, 1))
    turns = np.tile(still[:3, :3] / np.maximum(size, 1e-12), (count, 1, 1))
    if "rotation" in parts:
        turns = Rotation.from_quat(parts["rotation"]).as_matrix()
    out[:, :3, :3] = turns * parts.get("scale", size[None])[:, None, :]
    if "translation" in parts:
        out[:, :3, 3] = parts["translation"]
    return out
