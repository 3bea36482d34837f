"""Selection of the renderer: OpenGL if it draws in a trial, else the CPU alone.

MuJoCo reads MUJOCO_GL once, during its import, and an unusable value makes the import fail. Some drivers even abort the
process. OpenGL is therefore tried in a child process, and `choose` must run before the first `import mujoco`; this file
never imports mujoco.
"""

from __future__ import annotations

import functools
import os
import subprocess
import sys
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from importlib import import_module
from typing import Literal

TRIAL_SECONDS = 60.0  # [s] time limit of the trial
_SWITCHED_OFF = ("disable", "disabled", "off", "false", "0")
_INITIAL = {"MUJOCO_GL": value} if (value := os.environ.get("MUJOCO_GL")) is not None else {}

# a lit sphere in front of a black background, which detects contexts that draw nothing
_TRIAL = """
import mujoco
mujoco.set_mju_user_warning(lambda text: None)
model = mujoco.MjModel.from_xml_string(
    "<mujoco><worldbody><light pos='0 0 3'/><geom size='.5' rgba='1 1 1 1'/></worldbody></mujoco>")
data = mujoco.MjData(model)
mujoco.mj_forward(model, data)
with mujoco.Renderer(model, 32, 32) as renderer:
    renderer.update_scene(data)
    image = renderer.render()
print("drawn" if image.max() > 60 and image.min() < 30 else "blank")
"""


@dataclass(frozen=True)
class Graphics:
    """The renderer to use; line: a line for users, such as "renderer: OpenGL"."""

    kind: Literal["opengl", "software"]
    line: str


def choose() -> Graphics:
    """Return OpenGL if it works, else the software renderer, and set MUJOCO_GL for it.

    The backend of OpenGL is the MUJOCO_GL of the environment, by default EGL on Linux; `off` selects the software
    renderer. An imported mujoco can only use the backend of its import.
    """
    is_imported = "mujoco" in sys.modules
    backend = os.environ.get("MUJOCO_GL", "").strip().lower() or ("egl" if sys.platform == "linux" else "")
    if is_imported:
        backend = next((name for name in ("egl", "osmesa", "glfw", "cgl") if f"mujoco.{name}" in sys.modules), "off")
    if backend not in _SWITCHED_OFF and _draws(backend):
        if backend and not is_imported:
            os.environ["MUJOCO_GL"] = backend
        return Graphics("opengl", "renderer: OpenGL")
    do_without()
    if backend in _SWITCHED_OFF:
        return Graphics("software", f"renderer: software, on the CPU (MUJOCO_GL={backend})")
    install = "install libegl1 and libgl1, or " if sys.platform == "linux" else ""
    line = f"slow; no OpenGL with MUJOCO_GL={backend or 'unset'}: {install}set MUJOCO_GL to another one"
    return Graphics("software", f"renderer: software, on the CPU ({line})")


def choose_while_importing(names: Iterable[str]) -> Graphics:
    """Choose a renderer as `choose` does, and meanwhile import modules that do not import mujoco."""
    with ThreadPoolExecutor(1) as thread:
        trial = thread.submit(choose)
        for name in names:
            import_module(name)
        return trial.result()


def do_without() -> None:
    """Disable graphics for a process that draws nothing: its `import mujoco` is then faster and cannot fail."""
    if "mujoco" not in sys.modules:
        os.environ["MUJOCO_GL"] = _SWITCHED_OFF[0]


def drawing_environment() -> dict[str, str]:
    """Return the environment of a child process that draws, without the effect of `do_without` on this one."""
    return {name: value for name, value in os.environ.items() if name != "MUJOCO_GL"} | _INITIAL


@functools.cache
def _draws(backend: str) -> bool:
    """Return whether a child process can draw with this MUJOCO_GL; it contains exceptions, aborts and hangs."""
    if not sys.executable:
        return False
    try:
        child = subprocess.run(
            [sys.executable, "-P", "-c", _TRIAL],
            env={**os.environ, "MUJOCO_GL": backend},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=TRIAL_SECONDS,
            check=False,
        )
    except (OSError, subprocess.SubprocessError):
        return False
    return child.returncode == 0 and "drawn" in child.stdout.split()
