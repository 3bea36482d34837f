"""USD: bodies and geoms are where MuJoCo has them at every time code, and OpenUSD's own validators agree."""

from __future__ import annotations

import mujoco
import numpy as np
import puppet
import pytest
from oracles import kinematics

from dynsplines.exchange import formats
from dynsplines.exchange.skeleton import hierarchy
from dynsplines.exchange.trajectory import SampledTrajectory

Usd, UsdGeom = (pytest.importorskip(f"pxr.{name}") for name in ("Usd", "UsdGeom"))


@pytest.fixture(scope="module")
def take():
    return SampledTrajectory.of(puppet.moved(name="2 puppets"), 48.0)


@pytest.fixture(scope="module", params=["usda", "usdc"])
def stage(request, take, tmp_path_factory):
    target = tmp_path_factory.mktemp("usd") / f"a.{request.param}"
    opened = Usd.Stage.Open(str(formats.export(take.saved, "usd", target, fps=take.fps)))
    assert opened.GetRootLayer().GetFileFormat().formatId in ("usda", "usdc")
    return opened


@pytest.mark.slow
def test_bodies_are_where_mujoco_has_them_at_every_time_code(take, stage):
    found = {prim.GetDisplayName(): prim for prim in stage.Traverse() if prim.GetDisplayName()}
    for sample in (0, 1, len(take.time) // 2, len(take.time) - 1):
        cache = UsdGeom.XformCache(Usd.TimeCode(sample))
        for body, name in list(enumerate(hierarchy.names(take.model)))[1:]:
            matrix = np.array(cache.GetLocalToWorldTransform(found[name]))  # USD's vectors are rows
            np.testing.assert_allclose(matrix[3, :3], take.bodies.position[sample, body], atol=1e-6, err_msg=name)
            turn = np.zeros(9)
            mujoco.mju_quat2Mat(turn, take.bodies.rotation[sample, body])
            np.testing.assert_allclose(matrix[:3, :3].T, turn.reshape(3, 3), atol=1e-6, err_msg=name)


def test_geoms_reach_as_far_as_mujocos(take, stage):
    """The box round every geom that has one, in its own axes, is MuJoCo's aabb there."""
    data, model = kinematics(take.model, take.qpos[3]), take.model
    cache = UsdGeom.XformCache(Usd.TimeCode(3))
    shown = [g for g in range(model.ngeom) if model.geom_group[g] < 3]
    prims = {p.GetName(): p for p in stage.Traverse() if p.IsA(UsdGeom.Gprim)}
    assert len(prims) == len(shown)
    for geom in shown:
        name = model.geom(geom).name or f"geom{geom}"
        prim = prims[f"{name.replace(' ', '_')}_geom"]
        matrix = np.array(cache.GetLocalToWorldTransform(prim))
        np.testing.assert_allclose(matrix[3, :3], data.geom_xpos[geom], atol=1e-6)
        if model.geom_type[geom] in (int(mujoco.mjtGeom.mjGEOM_PLANE), int(mujoco.mjtGeom.mjGEOM_HFIELD)):
            continue
        extent = np.array(UsdGeom.Boundable(prim).GetExtentAttr().Get())
        scale = np.linalg.norm(matrix[:3, :3], axis=1)
        middle, half = model.geom_aabb[geom, :3], model.geom_aabb[geom, 3:]
        np.testing.assert_allclose(extent * scale, [middle - half, middle + half], atol=1e-5)
        np.testing.assert_allclose((matrix[:3, :3] / scale[:, None]).T.ravel(), data.geom_xmat[geom], atol=1e-6)


def test_time_codes_are_the_samples_and_the_rate_is_the_takes(take, stage):
    assert stage.GetTimeCodesPerSecond() == take.fps
    assert stage.GetFramesPerSecond() == take.fps
    assert (stage.GetStartTimeCode(), stage.GetEndTimeCode()) == (0, len(take.time) - 1)
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1
    assert UsdGeom.GetStageUpAxis(stage) == "Z"
    times = {tuple(op.GetTimeSamples()) for p in stage.Traverse() if p.IsA(UsdGeom.Xform)
             for op in UsdGeom.Xformable(p).GetOrderedXformOps()}  # fmt: skip
    assert times <= {(), tuple(map(float, range(len(take.time))))}
    assert len(times) == 2
    keys = stage.GetDefaultPrim().GetCustomDataByKey("keyframes")
    np.testing.assert_allclose(np.array(keys) / take.fps, [key.time for key in take.saved.keys], atol=1e-6)


def test_openusds_own_validators_find_nothing(stage):
    validation = pytest.importorskip("pxr.UsdValidation")
    context = validation.ValidationContext(validation.ValidationRegistry().GetOrLoadAllValidators())
    assert [str(error.GetMessage()) for error in context.Validate(stage)] == []
