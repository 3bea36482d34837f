"""Pictures of a figure in its scene, by OpenGL or by the CPU alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from types import TracebackType
from typing import Self

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from dynsplines.solver.array import Array
from dynsplines.solver.figure.model import set_qpos

from ..scene.assets import Scene
from ..scene.mujoco_versions import lamp, without_shadow
from .camera import View
from .film import Picture
from .graphics import Graphics

SHADOW_DETAIL = 8  # maximum texels of a shadow map for each pixel of the picture's longer side, with OpenGL
_SUN_DISTANCE = 6.0  # [m] distance of a directional light from the camera's target, around which it casts shadows


@dataclass(frozen=True)
class Ghost:
    """One more figure in a picture, as in the paper's figure 6: keyframes darkest, in-betweens lightest.

    Attributes:
        qpos: The configuration, (nq,).
        shade: 0 for the model's colours, 1 for white.
        opacity: 0 for invisible, 1 for opaque.
    """

    qpos: Array = field(repr=False)
    shade: float = 0.0
    opacity: float = 1.0


class Stage:
    """A renderer of pictures of a figure in its scene.

        with Stage(scene, 1280, 720, choose()) as stage:
            image = stage.picture(qpos, view)

    Call `graphics.choose` before the first import of mujoco, and hence of this file.
    """

    def __init__(self, scene: Scene, width: int, height: int, graphics: Graphics) -> None:
        """Open the renderer of pictures of this size [pixels]."""
        if width < 1 or height < 1:
            raise ValueError(f"a picture of {width}x{height} pixels; both must be at least 1")
        self.model = scene.spec().compile()
        flat = self.model.geom_type == int(mujoco.mjtGeom.mjGEOM_PLANE)
        without_shadow(self.model, flat)  # a floor's shadow on itself is only rounding
        self._data = mujoco.MjData(self.model)
        self._option, self._perturb = mujoco.MjvOption(), mujoco.MjvPerturb()
        self._option.sitegroup[:] = 0
        most = max(10_000, 100 * self.model.ngeom)
        if graphics.kind == "software":
            from .raster import Raster

            self._renderer: mujoco.Renderer | Raster = Raster(self.model, height, width, max_geom=most)
        else:
            window = self.model.vis.global_
            window.offwidth, window.offheight = width, height  # larger buffers are slow to clear
            quality = self.model.vis.quality
            quality.shadowsize = min(quality.shadowsize, SHADOW_DETAIL * max(width, height))  # also slow to clear
            self._renderer = mujoco.Renderer(self.model, height, width, max_geom=most)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Release the OpenGL context. No pictures can be drawn afterwards."""
        self._renderer.close()

    def picture(self, qpos: ArrayLike | None, view: View, *, ghosts: Sequence[Ghost] = ()) -> Picture:
        """Return the figure and its ghosts from a view, (height, width, 3).

        Translucent figures are drawn opaque and then blended, so that their inner parts do not shine through.

        Args:
            qpos: The main figure, (nq,); None: only the ghosts.
            ghosts: More figures, each with its shade.
        """
        figures = list(ghosts) if qpos is None else [Ghost(np.asarray(qpos, dtype=np.float64)), *ghosts]
        solid = [figure for figure in figures if figure.opacity == 1]
        plain = self._draw(solid, view)
        translucent = sorted({figure.opacity for figure in figures} - {0.0, 1.0})
        if not translucent:
            return plain
        out = plain.astype(np.float32)
        for opacity in translucent:
            sheet = self._draw([*solid, *(figure for figure in figures if figure.opacity == opacity)], view)
            covered = (np.abs(sheet.astype(np.int16) - plain) > 2).any(axis=-1)
            out[covered] += np.float32(opacity) * (sheet[covered] - out[covered])
        return np.rint(out).astype(np.uint8)

    def _draw(self, figures: Sequence[Ghost], view: View) -> Picture:
        scene = self._renderer.scene
        self._pose(figures[0].qpos if figures else self.model.qpos0)
        still, moving = int(mujoco.mjtCatBit.mjCAT_STATIC), int(mujoco.mjtCatBit.mjCAT_DYNAMIC)
        camera = self._camera(view)
        mujoco.mjv_updateScene(self.model, self._data, self._option, self._perturb, camera, still, scene)
        self._aim_shadows(scene, view)
        for figure in figures:
            self._pose(figure.qpos)
            start = scene.ngeom
            mujoco.mjv_addGeoms(self.model, self._data, self._option, self._perturb, moving, scene)
            for geom in scene.geoms[start : scene.ngeom]:
                geom.rgba[:3] += figure.shade * (1 - geom.rgba[:3])
        return self._renderer.render()

    def _pose(self, qpos: Array) -> None:
        set_qpos(self.model, self._data, qpos)
        mujoco.mj_camlight(self.model, self._data)

    def _aim_shadows(self, scene: mujoco.MjvScene, view: View) -> None:
        """Move directional lights with the camera, because shadows are drawn only near a light's position."""
        if view.fixed is not None:
            return
        for light in scene.lights[: scene.nlight]:
            if lamp(light) == "directional" and not light.headlight:
                light.pos[:] = np.asarray(view.lookat) - _SUN_DISTANCE * light.dir

    def _camera(self, view: View) -> mujoco.MjvCamera:
        camera = mujoco.MjvCamera()
        if view.fixed is not None:
            camera.type = int(mujoco.mjtCamera.mjCAMERA_FIXED)
            camera.fixedcamid = self.model.camera(view.fixed).id
            return camera
        camera.type = int(mujoco.mjtCamera.mjCAMERA_FREE)
        camera.lookat[:] = view.lookat
        camera.distance, camera.azimuth, camera.elevation = view.distance, view.azimuth, view.elevation
        return camera
