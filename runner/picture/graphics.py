"""Selection of the renderer: EGL, OSMesa, a display, or the CPU alone.

MuJoCo reads MUJOCO_GL once, during its import, and an unusable value makes the import fail. Some drivers even abort the
process. Every candidate is therefore tried in a child process, and `choose` must run before the first `import mujoco`;
this file never imports mujoco.
"""

from __future__ import annotations

import ctypes
import functools
import os
import subprocess
import sys
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from importlib import import_module
from typing import Literal

Kind = Literal["egl", "osmesa", "display", "software"]

PROBE_SECONDS = 60.0  # [s] time limit of a trial

_NAMES: dict[Kind, str] = {
    "egl": "EGL",
    "osmesa": "OSMesa",
    "display": "OpenGL on the display",
    "software": "software, on the CPU",
}
_SWITCHED_OFF = ("disable", "disabled", "off", "false", "0")
_FASTER = "slow; `apt-get install libosmesa6` or `libegl1 libgl1` makes it faster"
_IMPORTED = "mujoco was imported before a renderer was chosen, with one that does not work here"

# a lit sphere in front of a black background, which detects contexts that draw nothing
_PROBE = """
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
    """The renderer to use; line: a line for users, such as "renderer: EGL"."""

    kind: Kind
    line: str


def choose() -> Graphics:
    """Return the fastest working renderer, and set MUJOCO_GL for it.

    A MUJOCO_GL of the environment is tried first; `off` selects the software renderer. If its value does not work, it
    is removed from this process's environment, because `import mujoco` would fail.
    """
    if _imported():
        return _after_import(_imported_backend())
    wish = os.environ.get("MUJOCO_GL", "").strip().lower()
    if wish in _SWITCHED_OFF:
        return _settle("software", wish, f"MUJOCO_GL={wish}")
    if wish and _works(wish):
        return _settle(_kind_of(wish), wish)
    if wish:
        os.environ.pop("MUJOCO_GL", None)
    note = f"MUJOCO_GL={wish} does not work here" if wish else ""
    for backend in ("egl", "osmesa", "glfw") if sys.platform == "linux" else ("",):  # fastest first
        if backend != wish and _works(backend):
            return _settle(_kind_of(backend), backend, note)
    hint = _FASTER if sys.platform == "linux" else "slow"
    return _settle("software", None, "; ".join(part for part in (note, hint) if part))


def choose_while_importing(names: Iterable[str]) -> Graphics:
    """Choose a renderer as `choose` does, and meanwhile import modules that do not import mujoco."""
    with ThreadPoolExecutor(1) as thread:
        trial = thread.submit(choose)
        for name in names:
            import_module(name)
        return trial.result()


def do_without() -> None:
    """Disable graphics for a process that draws nothing: its `import mujoco` is then faster and cannot fail."""
    if not _imported():
        os.environ["MUJOCO_GL"] = _SWITCHED_OFF[0]


def _after_import(backend: str) -> Graphics:
    """Return the renderer of an imported mujoco, which can only use the backend of its import."""
    if backend not in _SWITCHED_OFF and _works(backend):
        return Graphics(_kind_of(backend), _line(_kind_of(backend)))
    return Graphics("software", _line("software", _IMPORTED))


def _settle(kind: Kind, backend: str | None, note: str = "") -> Graphics:
    """Set MUJOCO_GL to the working backend. The empty backend is MuJoCo's default and needs no variable."""
    if backend:
        os.environ["MUJOCO_GL"] = backend
    else:
        os.environ.pop("MUJOCO_GL", None)
    return Graphics(kind, _line(kind, note))


def _line(kind: Kind, note: str = "") -> str:
    return f"renderer: {_NAMES[kind]}" + (f" ({note})" if note else "")


def _kind_of(backend: str) -> Kind:
    return backend if backend == "egl" or backend == "osmesa" else "display"


def _imported() -> bool:
    return "mujoco" in sys.modules


def _imported_backend() -> str:
    """Return the MUJOCO_GL of the imported mujoco, from the module that it loaded, not from the present environment."""
    for backend in ("egl", "osmesa", "glfw"):
        if f"mujoco.{backend}" in sys.modules:
            return backend
    return "" if "mujoco.cgl" in sys.modules else "off"


def _works(backend: str) -> bool:
    """Return whether MuJoCo draws with this MUJOCO_GL. Without its libraries no process is started."""
    return _has_libraries(backend) and _draws(backend)


def _has_libraries(backend: str) -> bool:
    """Return whether a backend's libraries exist, which takes less than a millisecond."""
    if sys.platform != "linux":
        return True
    if backend == "egl":
        return _opens("libEGL.so.1") and _opens("libOpenGL.so.0", "libGL.so.1")
    if backend == "osmesa":
        return _opens("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so")
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def _opens(*names: str) -> bool:
    """Return whether one of these shared libraries loads."""
    for name in names:
        try:
            ctypes.CDLL(name)
        except OSError:
            continue
        return True
    return False


@functools.cache
def _draws(backend: str) -> bool:
    """Return whether a child process can draw; it contains exceptions, aborts and hangs."""
    if not sys.executable:
        return False
    environment = {**os.environ, "MUJOCO_GL": backend}
    if not backend:
        del environment["MUJOCO_GL"]
    try:
        child = subprocess.run(
            [sys.executable, "-P", "-c", _PROBE],
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=PROBE_SECONDS,
            check=False,
        )
    except (OSError, subprocess.SubprocessError):
        return False
    return child.returncode == 0 and "drawn" in child.stdout.split()
