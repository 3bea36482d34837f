"""Images a second: our OpenGL renderer against a bare mujoco.Renderer loop, and the CPU alone with two processes.

    python benchmarks/rendering.py IMAGES REPEATS SIZE      OpenGL alone, its figures as JSON

OpenGL is measured in a process of its own: a renderer must be chosen before mujoco is imported.
"""

from __future__ import annotations

import pinned  # noqa: F401  isort: skip  # before anything that imports NumPy

import itertools
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from bench import CLIP, Effort, Section, Target, alternated, dynsplines, median, seconds

SIZE, SOFTWARE_SIZE = "1280x720", "1280x720"
FPS = 30
SOFTWARE_SECONDS_OF_CLIP = 2.2


def opengl(images: int, repeats: int, size: str) -> dict[str, Any]:
    """Seconds for the same images as a video, by us and by a bare loop; why not, where there is no OpenGL."""
    from dynsplines.picture.graphics import choose

    graphics = choose()
    if graphics.kind == "software":
        return {"renderer": graphics.line, "missing": "no OpenGL here"}

    from dynsplines import recordings, solving
    from dynsplines.picture import film, show

    width, height = map(int, size.split("x"))
    saved = solving.raw_spline(recordings.load(CLIP))
    look = show.Look(width, height, float(FPS))
    with tempfile.TemporaryDirectory() as folder:

        def ours() -> None:
            frames = itertools.islice(show.images(saved, look, graphics), images)
            film.write(Path(folder) / "ours.mp4", frames, float(FPS))

        def bare() -> None:
            _bare(saved, look, images, Path(folder) / "bare.mp4")

        times, _ = alternated({"ours": ours, "bare": bare}, repeats)
    return {"renderer": graphics.line, "times": times, "images": images, "size": size}


def _bare(saved: Any, look: Any, images: int, target: Path) -> None:
    """A minimal implementation with MuJoCo: two pictures side by side, a moving camera, and a pyav writer."""
    import imageio.v3 as iio
    import mujoco
    import numpy as np

    from dynsplines.motion import Sampled

    model = mujoco.MjModel.from_xml_string(saved.mjcf)
    data = mujoco.MjData(model)
    half = look.width // 2
    model.vis.global_.offwidth, model.vis.global_.offheight = half, look.height
    runs = [Sampled.of(side, look.fps).qpos for side in (saved.before, saved)]
    camera = mujoco.MjvCamera()
    camera.distance, camera.azimuth, camera.elevation = 4.0, 90.0, -8.0
    with mujoco.Renderer(model, look.height, half) as renderer, iio.imopen(target, "w", plugin="pyav") as video:
        writer: Any = video
        writer.init_video_stream("libx264", fps=FPS)
        writer._video_stream.codec_context.thread_count = 1
        for i in range(images):
            sides = []
            for qpos in runs:
                data.qpos[:] = qpos[i]
                mujoco.mj_forward(model, data)
                camera.lookat[:] = qpos[i, :3]
                renderer.update_scene(data, camera)
                sides.append(renderer.render())
            writer.write_frame(np.hstack(sides))


def software(workers: int, folder: Path, fps: float) -> tuple[float, str | None]:
    """Seconds for a small video by the CPU alone with so many processes, and why not."""
    command = dynsplines("render", CLIP, "--only", "before", "--size", SOFTWARE_SIZE, "--fps", f"{fps:g}")
    command += ["-o", str(folder / f"software{workers}.mp4"), "--workers", str(workers)]
    environment = os.environ | {"MUJOCO_GL": "off", "TERM": "dumb"}
    spent, done = seconds(lambda: subprocess.run(command, capture_output=True, text=True, env=environment, check=False))
    if done.returncode == 0:
        return spent, None
    lines = [line.strip(" │╭╮╰╯─") for line in done.stderr.splitlines()]
    return spent, next((line for line in reversed(lines) if line), f"ended with {done.returncode}")


def measure(effort: Effort) -> Section:
    section = Section(
        "Rendering run_and_step, before | after, into H.264",
        ("renderer", "size", "images", "images a second", "bare loop or one process", "×"),
    )
    images = effort.count(30, 4)
    effort.report(f"OpenGL, {images} images, {effort.repeats} times")
    command = [sys.executable, str(Path(__file__).resolve()), str(images), str(effort.repeats), SIZE]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    gl: dict[str, Any] = json.loads(done.stdout.splitlines()[-1]) if done.returncode == 0 else {}
    share = None
    if "times" in gl:
        ours, bare = (images / median(gl["times"][name]) for name in ("ours", "bare"))
        share = ours / bare
        section.add(gl["renderer"], SIZE, images, ours, bare, share)
    else:
        section.add("OpenGL", SIZE, "–", f"skipped: {gl.get('missing', done.stderr[-200:])}", "–", "–")
    cast = _software(section, effort)
    section.targets = [
        Target("OpenGL: ours / a bare mujoco.Renderer loop", share, 0.9, least=True),
        Target("software: two processes / one, the whole command", cast.get("gain"), 1.7, least=True),
    ]
    section.notes = [
        "OpenGL: opening the renderer, drawing two pictures an image, captions (ours only), encoding by one thread; "
        "the same MJCF, shadows and multisampling, x264's medium preset; the bare loop at the default crf 23, ours 18",
        "software: `dynsplines render --only before` (no solving) in child processes, starting included; this machine "
        f"has {os.cpu_count()} cores",
    ]
    section.data = {"opengl": gl, "software": cast}
    return section


def _software(section: Section, effort: Effort) -> dict[str, Any]:
    """The row of the CPU alone, and its figures."""
    fps = effort.count(20, 2)
    images = int(SOFTWARE_SECONDS_OF_CLIP * fps + 1e-9) + 1
    spent: dict[int, list[float]] = {1: [], 2: []}
    with tempfile.TemporaryDirectory() as folder:
        for i in range(effort.repeats):
            for workers in spent:
                effort.report(f"software, {workers} processes, run {i + 1}")
                took, why = software(workers, Path(folder), float(fps))
                if why is not None:
                    section.add("software, two processes", SOFTWARE_SIZE, images, f"skipped: {why}", "–", "–")
                    return {"missing": why}
                spent[workers].append(took)
    one, two = (images / median(spent[workers]) for workers in (1, 2))
    section.add("software, two processes", SOFTWARE_SIZE, images, two, one, two / one)
    return {"seconds": spent, "images": images, "gain": two / one}


if __name__ == "__main__":
    print(json.dumps(opengl(int(sys.argv[1]), int(sys.argv[2]), sys.argv[3])))
