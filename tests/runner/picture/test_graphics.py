"""A renderer is chosen by trying it in a child process, and a bad setting never gets as far as `import mujoco`."""

import os
import subprocess
import sys

import pytest

from dynsplines.picture import graphics

SHOW = """
import os
from dynsplines.picture.graphics import choose
found = choose()
print(found.kind)
print(found.line)
print(os.environ.get("MUJOCO_GL", "unset"))
import mujoco
"""


def choose_in_a_fresh_process(code: str = SHOW, **settings: str) -> list[str]:
    """The lines a new interpreter prints with these settings in its environment."""
    names = ("MUJOCO_GL", "PYOPENGL_PLATFORM")
    environment = {name: value for name, value in os.environ.items() if name not in names}
    done = subprocess.run(
        [sys.executable, "-c", code], env={**environment, **settings}, capture_output=True, text=True, timeout=120
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def no_backend_works(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(graphics, "_works", lambda backend: False)


def before_mujoco_is_imported(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(graphics, "_imported", lambda: False)


@pytest.mark.slow
def test_a_mujoco_gl_that_does_not_exist_is_named_and_removed_and_another_taken():
    kind, line, left = choose_in_a_fresh_process(MUJOCO_GL="nonsense")
    assert kind in ("egl", "osmesa", "display", "software")
    assert line.startswith("renderer: ") and "MUJOCO_GL=nonsense does not work here" in line
    assert left != "nonsense"


@pytest.mark.slow
def test_a_mujoco_gl_whose_platform_clashes_is_removed_before_it_can_raise():
    kind, _, left = choose_in_a_fresh_process(MUJOCO_GL="egl", PYOPENGL_PLATFORM="glx")
    assert kind != "egl"
    assert left != "egl"


def test_drawing_without_opengl_can_be_selected():
    assert choose_in_a_fresh_process(MUJOCO_GL="off") == [
        "software",
        "renderer: software, on the CPU (MUJOCO_GL=off)",
        "off",
    ]


def test_after_mujoco_is_imported_only_its_own_backend_counts():
    code = "import os, mujoco\nos.environ['MUJOCO_GL'] = 'nonsense'\n" + SHOW
    assert choose_in_a_fresh_process(code, MUJOCO_GL="disable")[0] == "software"


def test_without_any_gl_library_software_is_chosen_and_the_packages_are_named(monkeypatch: pytest.MonkeyPatch):
    before_mujoco_is_imported(monkeypatch)
    no_backend_works(monkeypatch)
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setenv("MUJOCO_GL", "osmesa")
    found = graphics.choose()
    assert found.kind == "software"
    assert "MUJOCO_GL=osmesa does not work here" in found.line
    assert "libosmesa6" in found.line
    assert "MUJOCO_GL" not in os.environ


def test_the_fastest_backend_that_works_is_taken(monkeypatch: pytest.MonkeyPatch):
    before_mujoco_is_imported(monkeypatch)
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr(graphics, "_works", lambda backend: backend in ("osmesa", "glfw"))
    monkeypatch.setenv("MUJOCO_GL", "")
    assert graphics.choose() == graphics.Graphics("osmesa", "renderer: OSMesa")
    assert os.environ["MUJOCO_GL"] == "osmesa"


@pytest.mark.parametrize(
    "probe", ["import os; print('drawn', flush=True); os.abort()", "print('blank')", "import time; time.sleep(60)"]
)
def test_a_driver_that_aborts_draws_nothing_or_hangs_does_not_pass(monkeypatch: pytest.MonkeyPatch, probe: str):
    monkeypatch.setattr(graphics, "_PROBE", probe)
    monkeypatch.setattr(graphics, "PROBE_SECONDS", 1.0)
    assert not graphics._draws.__wrapped__("egl")


def test_nothing_is_launched_when_the_libraries_are_absent(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr(graphics, "_opens", lambda *names: False)
    monkeypatch.setattr(graphics, "_draws", lambda backend: pytest.fail("a process was launched"))
    assert not graphics._works("egl")


def test_modules_that_are_imported_while_a_renderer_is_chosen_leave_mujoco_to_it():
    script = (
        "import sys, importlib; from dynsplines import cli\n"
        "for name in cli.BEFORE_MUJOCO: importlib.import_module(name)\n"
        "assert 'mujoco' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", script], check=True)
