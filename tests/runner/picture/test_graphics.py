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


@pytest.mark.slow
def test_opengl_that_does_not_work_is_named_and_does_not_stop_mujoco():
    kind, line, left = choose_in_a_fresh_process(MUJOCO_GL="egl", PYOPENGL_PLATFORM="glx")
    assert (kind, left) == ("software", "disable")
    assert "no OpenGL with MUJOCO_GL=egl" in line
    assert "libegl1" in line or sys.platform != "linux"


def test_drawing_without_opengl_can_be_selected_and_after_the_import_of_mujoco_only_its_own_backend_counts():
    line = "renderer: software, on the CPU (MUJOCO_GL=off)"
    assert choose_in_a_fresh_process(MUJOCO_GL="off")[:2] == ["software", line]
    code = "import os, mujoco\nos.environ['MUJOCO_GL'] = 'nonsense'\n" + SHOW
    assert choose_in_a_fresh_process(code, MUJOCO_GL="disable")[0] == "software"


@pytest.mark.parametrize("settings", [{}, {"MUJOCO_GL": "osmesa"}])
def test_a_child_process_of_one_that_draws_nothing_may_draw(settings: dict[str, str]):
    code = "import os\nfrom dynsplines.picture import graphics\ngraphics.do_without()\nprint(os.environ['MUJOCO_GL'])\n"
    code += "print(graphics.drawing_environment().get('MUJOCO_GL'))"
    assert choose_in_a_fresh_process(code, **settings) == ["disable", str(settings.get("MUJOCO_GL"))]


@pytest.mark.parametrize(
    "trial", ["import os; print('drawn', flush=True); os.abort()", "print('blank')", "import time; time.sleep(60)"]
)
def test_a_driver_that_aborts_draws_nothing_or_hangs_does_not_pass(monkeypatch: pytest.MonkeyPatch, trial: str):
    monkeypatch.setattr(graphics, "_TRIAL", trial)
    monkeypatch.setattr(graphics, "TRIAL_SECONDS", 1.0)
    assert not graphics._draws.__wrapped__("egl")


def test_modules_that_are_imported_while_a_renderer_is_chosen_leave_mujoco_to_it():
    script = (
        "import sys, importlib; from dynsplines import cli\n"
        "for name in cli.BEFORE_MUJOCO: importlib.import_module(name)\n"
        "assert 'mujoco' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", script], check=True)
