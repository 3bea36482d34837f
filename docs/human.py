"""The picture of the figure `human` in docs/keyframes.md: python docs/human.py [-o renders/human.webp]

It shows the names of joints and sites, the world axes, and the direction of positive angles in some poses.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from dynsplines.picture import graphics

GRAPHICS = graphics.choose()  # before the first import of mujoco

import mujoco  # noqa: E402
from numpy.typing import NDArray  # noqa: E402
from PIL import Image, ImageDraw, ImageFont  # noqa: E402

from dynsplines import Keyframe, build  # noqa: E402
from dynsplines.picture.camera import View, axes  # noqa: E402
from dynsplines.picture.show import caption  # noqa: E402
from dynsplines.picture.stage import Stage  # noqa: E402
from dynsplines.solver.figure.model import set_qpos  # noqa: E402

Array = NDArray[np.float64]
ROOT = Path(__file__).parents[1]
WIDTH, HEIGHT, POSE = 560, 720, 240  # [pixels]
INK, SITE = (24, 30, 38), (20, 90, 200)
AXES = {"x": (200, 40, 40), "y": (30, 140, 60), "z": (30, 70, 200)}
ARMS = {"left_shoulder": {"rotvec": [25, 0, 0]}, "right_shoulder": {"rotvec": [-25, 0, 0]}}
POSES = {  # captions, the camera's azimuth [degrees], and joints
    "left_shoulder rotvec [40, 0, 0]": (180, {"left_shoulder": {"rotvec": [40, 0, 0]}}),
    "left_shoulder rotvec [0, -90, 0]": (90, {"left_shoulder": {"rotvec": [0, -90, 0]}}),
    "left_elbow rotvec [0, -90, 0]": (90, {"left_elbow": {"rotvec": [0, -90, 0]}}),
    "left_hip [0, -70, 0], left_knee [0, 70, 0]": (
        90,
        {"left_hip": {"rotvec": [0, -70, 0]}, "left_knee": {"rotvec": [0, 70, 0]}},
    ),
    "spine rotvec [0, 30, 0]": (90, {"spine": {"rotvec": [0, 30, 0]}}),
    "spine rotvec [0, 0, 45]": (180, {"spine": {"rotvec": [0, 0, 45]}}),
}


def font(size: int) -> ImageFont.ImageFont | ImageFont.FreeTypeFont:
    return ImageFont.load_default(size)


def arrow(draw: ImageDraw.ImageDraw, points: Array, color: tuple[int, int, int]) -> None:
    """Draw a polyline (n, 2) [pixels] with a head at its end."""
    draw.line([tuple(point) for point in points], fill=color, width=4, joint="curve")
    tip, forward = points[-1], points[-1] - points[-2]
    forward = 13 * forward / np.linalg.norm(forward)
    side = 0.45 * np.array([-forward[1], forward[0]])
    draw.polygon(
        [tuple(tip + 0.5 * forward), tuple(tip - 0.5 * forward + side), tuple(tip - 0.5 * forward - side)], color
    )


class Projection:
    """The camera of a picture, from places in the world to pixels."""

    def __init__(self, view: View, model: mujoco.MjModel, width: int, height: int) -> None:
        self.rows, self.view = axes(view.azimuth, view.elevation), view
        self.focus = height / 2 / np.tan(np.radians(model.vis.global_.fovy) / 2)
        self.middle = np.array([width / 2, height / 2])

    def __call__(self, places: Array) -> Array:
        """Return the pixels (..., 2) of places (..., 3) [m]."""
        right, up, forward = np.moveaxis((np.asarray(places) - self.view.lookat) @ self.rows.T, -1, 0)
        depth = forward + self.view.distance
        return self.middle + self.focus * np.stack([right / depth, -up / depth], axis=-1)


def draw_axes(draw: ImageDraw.ImageDraw, project: Projection, origin: Array) -> None:
    """Draw the world axes, each with the direction of positive rotation."""
    for i, (name, color) in enumerate(AXES.items()):
        unit, first, second = np.roll(np.eye(3), i, axis=1)
        arrow(draw, project(origin + np.array([np.zeros(3), 0.22 * unit])), color)
        angles = np.linspace(0.2 * np.pi, 1.75 * np.pi, 40)[:, None]
        arrow(draw, project(origin + 0.13 * unit + 0.05 * (np.cos(angles) * first + np.sin(angles) * second)), color)
        at = project(origin + 0.28 * unit)
        label = {"x": "x forward", "y": "y left", "z": "z up"}[name]
        draw.text(tuple(at), label, color, font(17), anchor="mm", stroke_width=2, stroke_fill="white")


def names(stage: Stage, qpos: Array, model: mujoco.MjModel) -> Image.Image:
    """Return the picture with the names of joints and sites."""
    view = View((0.0, 0.0, 0.87), 3.3, 153.0, -10.0)
    picture = Image.fromarray(stage.picture(qpos, view))
    draw, project, data = ImageDraw.Draw(picture), Projection(view, model, WIDTH, HEIGHT), mujoco.MjData(model)
    set_qpos(model, data, qpos)
    mujoco.mj_kinematics(model, data)
    joints = {model.joint(i).name: project(data.xanchor[i]) for i in range(model.njnt)}
    sites = {model.site(i).name: project(data.site_xpos[i]) for i in range(model.nsite)}
    sides = {True: ({}, {}), False: ({}, {})}
    for kind, points in enumerate((joints, sites)):
        for name, point in points.items():
            sides[point[0] < WIDTH / 2][kind][name] = point
    for is_left, both in sides.items():
        rows = {name: (point, kind) for kind in (0, 1) for name, point in both[kind].items()}
        previous = -99.0
        for name, (point, kind) in sorted(rows.items(), key=lambda item: item[1][0][1]):
            color = (INK, SITE)[kind]
            previous = y = max(point[1], previous + 20)
            x, anchor = (12, "lm") if is_left else (WIDTH - 12, "rm")
            box = draw.textbbox((x, y), name, font(16), anchor=anchor)
            draw.line([(box[2] + 4 if is_left else box[0] - 4, y), tuple(point)], fill=color, width=1)
            draw.ellipse([*(point - 4), *(point + 4)], fill=color, outline="white")
            draw.text((x, y), name, color, font(16), anchor=anchor, stroke_width=2, stroke_fill="white")
    draw.text(
        (WIDTH / 2, 18), "joints black, sites blue", INK, font(17), anchor="mm", stroke_width=2, stroke_fill="white"
    )
    draw_axes(draw, project, np.array([0.1, -0.5, 0.36]))
    return picture


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "renders" / "human.webp")
    target = parser.parse_args().output
    keys = [Keyframe(0.0, others="rest", joints=ARMS), Keyframe(1.0, others="rest")]
    keys += [Keyframe(2.0 + i, others="rest", joints=joints) for i, (_, joints) in enumerate(POSES.values())]
    clip = build("human", keys)
    poses, scene, model = [key.state for key in clip.keys], clip.scene, clip.figure.model
    sheet = Image.new("RGB", (WIDTH + 3 * POSE, HEIGHT), "white")
    with Stage(scene, WIDTH, HEIGHT, GRAPHICS) as stage:
        sheet.paste(names(stage, poses[0], model), (0, 0))
    with Stage(scene, POSE - 4, HEIGHT // 2 - 2, GRAPHICS) as stage:
        for i, (title, (azimuth, _)) in enumerate(POSES.items()):
            picture = stage.picture(poses[2 + i], View((0.0, 0.0, 0.93), 3.4, azimuth, -8.0))
            place = WIDTH + 4 + i % 3 * POSE, i // 3 * (HEIGHT // 2 + 2)
            sheet.paste(Image.fromarray(caption(picture, title)), place)
    sheet.save(target, quality=80, method=6)


if __name__ == "__main__":
    main()
