"""Files that joblib has written, as ASAP and PHC keep their motions, and those of LocoMuJoCo before 1.0."""

import base64
import bz2
import gzip
import lzma
import pickle
import zlib
from typing import Any

import mujoco
import numpy as np
import pytest
import walking_biped as biped

from dynsplines.errors import UserError
from dynsplines.exchange import plain_pickle
from dynsplines.exchange.formats import recording

# joblib 1.6, joblib.dump({"walk": {"root_trans_offset", "pose_aa", "dof", "root_rot", "fps"}}), six samples of a walk;
# `dof` in Fortran's order, `pose_aa` in single precision
JOBLIB = zlib.decompress(base64.b64decode(
    "eNprYJn6mQECaqf0sJQn5mRPqZ2i0SNYlJ9fEl9SlJhXHJ+fllacWjKlRzgrPyknM0kvrzS3oDK+IDM5Oyd1So+gH4jrWFSUWBle"
    "lFhQkFo0ZfIUzUawKRzFpUnJOYnFxVN6WMG6pvSw56UkgtQCFfWwFmckFqRO8WbzZm4D8vKLUoCaexidgeyUkkqgTAYXjAVUzZRm"
    "MaWzo31K0BQNb+YeRpspfn5+Xv+BAEx4M5RMSerhSszJyS+Pz81NLJjS0SMNcSnYvvjEnMz0vNzUvJL4pMqS1OIp3gKlSYz/GdDA"
    "OveHVSLrntt/K2jnneDRYm/beWz7jQPV9qjiU6Di3XDxAk1vkRs58+zfPrvSuejCFDT1S6DqZ8PFjX1fCmyJWml/TPROUXvEQrj4"
    "1GCoQ3rYC/KLU+MTE6dksEFCM4MzgyeDFxhYTN7M7VMy+DMEMgQzhIHBYoIIlgxxzEDJkOzIkAL5lhkoAvPnrJmS9gxYAL3Fp+rC"
    "/Muckp+G6Vf2NqBPexjdpgD9Kgb3Ced/GICZ45DXt9jXYbH956xV+oWSm+1l/yV3zXfdY//vtP3FK/WH7JfMj2TVmnTM3t365Rb1"
    "2Y/2b/g4u3JW0qP93w30r9yVf7S/VLtbYs7lh/sXGZhxJNc93O/DoSy/SuHhfpXd571C457ZB1SJXzzB9dw+I3vBfd+lz+1XrMo8"
    "zKP/wl5hwtvmzyte2GvUXcs7JPzS/sU/4/U5kvv2Nyi9i9254ND+Iy+P6B4QPbb/zJ/K1YdyT+7/UXv3neOqM/sLrp+1Szxzfv+P"
    "yuoJirEH9od4r2KYcenYfsMLqhKf7p3Zv0+3xc7M4+L+Y1bXX2z8fnm/6uLYMpeGa3D3zGl7VsY34YV9Q5Fx9Zq2V/ZfeHwFj3q8"
    "sedYx/fX7NZbe4nUqC1utu/tl93Z8IzH/dH+4593l2XcfrS/5J/m1/d+j/eLfuP6tHLJ4/1LBRZzxN17vL9tsnalyt/H+6cawOKD"
    "A1wCFOWXYEYKSxss+SGihA01PmDAeNeuqWdfXrLfxal/RXbSO/vBLj+VG54e0wqAhYRRabEeALuK8xg="
))  # fmt: skip
QPOS = biped.walk(6)
COMPRESSED = {"none": bytes, "zlib": zlib.compress, "gzip": gzip.compress, "bz2": bz2.compress, "xz": lzma.compress,
              "lzma": lambda data: lzma.compress(data, lzma.FORMAT_ALONE)}  # fmt: skip


def read(path, fps=None, model=None):
    return recording(path, model=model or biped.model(), fps=fps)


@pytest.mark.parametrize("compress", COMPRESSED.values(), ids=COMPRESSED)
@pytest.mark.parametrize("ending", ["pkl", "joblib"])
def test_joblibs_motions_of_robots_are_read(compress, ending, tmp_path):
    (tmp_path / f"a.{ending}").write_bytes(compress(JOBLIB))
    found = read(tmp_path / f"a.{ending}")
    np.testing.assert_allclose(found.qpos, QPOS, atol=1e-12)
    assert found.fps == 50 and not found.notes


def entries():
    turn = QPOS[:, [4, 5, 6, 3]]
    return {"root_trans_offset": QPOS[:, :3], "dof": QPOS[:, 7:, None], "root_rot": turn, "fps": 50}


def test_the_root_is_verified_by_its_rotation_vector(tmp_path):
    vector = np.zeros((6, 3, 3))
    vector[:, 0, 2] = 0.6  # the heading of the walk
    for turn in (QPOS[:, [4, 5, 6, 3]], QPOS[:, 3:7]):
        motion = entries() | {"pose_aa": vector, "root_rot": turn}
        (tmp_path / "a.pkl").write_bytes(pickle.dumps({"walk": motion}))
        np.testing.assert_allclose(read(tmp_path / "a.pkl").qpos, QPOS, atol=1e-12)
    motion["pose_aa"] = vector * 2
    (tmp_path / "a.pkl").write_bytes(pickle.dumps({"walk": motion}))
    with pytest.raises(UserError, match=r"differ from the figure's .* 0\.0 cm and 34\.4°"):
        read(tmp_path / "a.pkl")


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ({"a": entries(), "b": entries()}, "it holds 2 motions: a, b; save one of them alone"),
        ({"a": {"root_trans_offset": QPOS[:, :3], "pose_aa": np.zeros((6, 72)), "fps": 30}}, "--from amass"),
        ({"a": entries() | {"dof": QPOS[:, 8:]}}, "6 joints; the figure has 7"),
    ],
)
def test_motions_that_are_not_one_robots_are_refused(content, message, tmp_path):
    (tmp_path / "a.pkl").write_bytes(pickle.dumps(content))
    with pytest.raises(UserError, match=message):
        recording(tmp_path / "a.pkl", "gmr", model=biped.model())


@pytest.mark.parametrize("cut", [200, 900, len(JOBLIB) - 30])
@pytest.mark.parametrize("compress", [bytes, zlib.compress, gzip.compress])
def test_files_of_joblib_that_are_cut_short_are_refused(cut, compress, tmp_path):
    data = JOBLIB[:cut] if compress is bytes else compress(JOBLIB)[: cut // 2]
    (tmp_path / "a.pkl").write_bytes(data)
    with pytest.raises(UserError, match=r"a\.pkl: ") as error:
        plain_pickle.load(tmp_path / "a.pkl")
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("before", "after"),
    [(b"NumpyArrayWrapper", b"NumpyArrayRwapper"), (b"joblib.numpy_pickle", b"joblib.numpy_hackle")],
)
def test_other_names_of_joblib_are_refused(before, after, tmp_path):
    assert before in JOBLIB
    (tmp_path / "a.pkl").write_bytes(JOBLIB.replace(before, after))
    with pytest.raises(UserError, match="only numbers, texts, lists and numpy arrays are loaded"):
        plain_pickle.load(tmp_path / "a.pkl")


def test_what_would_inflate_beyond_the_bound_is_refused(tmp_path, monkeypatch):
    monkeypatch.setenv("DYNSPLINES_LARGEST", "1")
    for compress in (zlib.compress, gzip.compress, bz2.compress, lzma.compress):
        (tmp_path / "a.pkl").write_bytes(compress(bytes(3_000_000)))
        with pytest.raises(UserError, match="decompressed, comes to"):
            plain_pickle.load(tmp_path / "a.pkl")


OLD = """
<mujoco><worldbody><body name="pelvis"><joint name="pelvis_tx" type="slide" axis="1 0 0"/>
  <joint name="pelvis_tz" type="slide" axis="0 0 1"/><joint name="pelvis_tilt" axis="0 1 0"/><geom size=".1"/>
  <body name="thigh" pos="0 0 -.1"><joint name="hip" axis="0 1 0" range="-1 1"/><geom size=".1" pos="0 0 -.4"/>
</body></body></worldbody></mujoco>
"""


def test_files_of_locomujoco_before_1_0_are_read_for_its_models(tmp_path):
    model = mujoco.MjModel.from_xml_string(OLD)
    names = [model.joint(j).name for j in range(model.njnt)]
    qpos = np.random.default_rng(1).uniform(-0.5, 0.5, (9, 4))
    arrays: dict[str, Any] = {f"q_{name}": qpos[:, i] for i, name in enumerate(names)}
    arrays |= {f"dq_{name}": np.zeros(9) for name in names}
    np.savez(tmp_path / "a.npz", **dict(reversed(arrays.items())))
    found = read(tmp_path / "a.npz", 100.0, model)
    np.testing.assert_array_equal(found.qpos, qpos)
    assert found.fps == 100
    with pytest.raises(UserError, match=r"before 1\.0 has no rate; give the rate"):
        read(tmp_path / "a.npz", None, model)
    with pytest.raises(
        UserError, match=r"LocoMuJoCo before 1\.0, with no 'q_root'; .* model, of the joints hip, pelvis"
    ):
        read(tmp_path / "a.npz", 100.0)
    np.savez(tmp_path / "b.npz", **arrays, split_points=np.array([0, 4, 9]))
    with pytest.raises(UserError, match="holds 2 motions"):
        read(tmp_path / "b.npz", 100.0, model)
