"""A renderer is chosen by trying it in a child process, and a bad setting never gets as far as `import mujoco`."""

import os
import subprocess
import sys

import pytest

from dynsplines.errors import UserError
from dynsplines.picture import graphics

TELLS_ITS_START = pytest.mark.skipif(
    not graphics.BOOT.is_file(), reason="nobody says when the machine was started, so nothing is remembered"
)

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
    names = ("MUJOCO_GL", "PYOPENGL_PLATFORM", graphics.OVERRIDE)
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
    monkeypatch.delenv(graphics.OVERRIDE, raising=False)


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


def test_drawing_without_opengl_can_be_forced_even_when_mujoco_gl_is_broken():
    kind, line, left = choose_in_a_fresh_process(MUJOCO_GL="nonsense", DYNSPLINES_RENDERER="rays")
    assert (kind, left) == ("software", "unset")  # which was called "rays"
    assert "DYNSPLINES_RENDERER=software" in line


def test_after_mujoco_is_imported_only_its_own_backend_counts():
    code = "import os, mujoco\nos.environ['MUJOCO_GL'] = 'nonsense'\n" + SHOW
    assert choose_in_a_fresh_process(code, MUJOCO_GL="disable")[0] == "software"


@pytest.mark.parametrize(
    ("name", "told"),
    [("vulkan", "no such renderer; renderers: egl, osmesa, display, software"), ("egl", "egl does not work here")],
)
def test_a_forced_renderer_that_does_not_exist_or_work_is_an_error(monkeypatch: pytest.MonkeyPatch, name, told):
    before_mujoco_is_imported(monkeypatch)
    no_backend_works(monkeypatch)
    monkeypatch.setenv(graphics.OVERRIDE, name)
    with pytest.raises(UserError, match=told):
        graphics.choose()


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


@TELLS_ITS_START
def test_what_drew_is_remembered_until_something_that_it_depends_on_is_another(monkeypatch, tmp_path):
    monkeypatch.setenv("DYNSPLINES_CACHE", str(tmp_path))
    tries: list[str] = []
    monkeypatch.setattr(graphics, "_tried", lambda backend: not tries.append(backend))
    draws = graphics._draws.__wrapped__
    assert draws("egl") and draws("egl")
    assert tries == ["egl"]
    assert draws("osmesa")
    monkeypatch.setenv("LIBGL_ALWAYS_SOFTWARE", "1")
    assert draws("egl")
    assert tries == ["egl", "osmesa", "egl"]
    (file,) = tmp_path.glob("draws-egl*")
    long_ago = file.stat().st_mtime - 2 * graphics.REMEMBERED
    os.utime(file, (long_ago, long_ago))
    assert draws("egl")
    monkeypatch.setenv("DYNSPLINES_CACHE", "off")
    assert draws("egl")
    assert tries == ["egl", "osmesa", "egl", "egl", "egl"]


@TELLS_ITS_START
def test_what_did_not_draw_is_tried_again_and_a_folder_that_cannot_be_written_is_no_error(monkeypatch, tmp_path):
    draws = graphics._draws.__wrapped__
    monkeypatch.setenv("DYNSPLINES_CACHE", str(tmp_path))
    monkeypatch.setattr(graphics, "_tried", lambda backend: False)
    assert not draws("egl")
    assert not list(tmp_path.iterdir())
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("DYNSPLINES_CACHE", str(tmp_path / "file"))
    monkeypatch.setattr(graphics, "_tried", lambda backend: True)
    assert draws("egl")


def test_nothing_is_launched_when_the_libraries_are_absent(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr(graphics, "_opens", lambda *names: False)
    monkeypatch.setattr(graphics, "_draws", lambda backend: pytest.fail("a process was launched"))
    assert not graphics._works("egl")
