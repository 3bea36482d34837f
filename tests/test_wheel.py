"""The wheel holds the three packages with their data and nothing else, and works from an empty folder."""

from __future__ import annotations

import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PIP = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--no-input", "-q"]
READ = "import models; print(models.__file__); print(models.clip_text('run_and_step')); print(models.figures())"


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    pytest.importorskip("hatchling")
    folder = tmp_path_factory.mktemp("wheel")
    command = [*PIP, "wheel", "--no-deps", "--no-build-isolation", "--no-index", "-w", str(folder), str(ROOT)]
    subprocess.run(command, check=True, capture_output=True, text=True)
    (built,) = folder.glob("*.whl")
    return built


@pytest.fixture(scope="module")
def contents(wheel: Path) -> set[str]:
    with zipfile.ZipFile(wheel) as archive:
        return set(archive.namelist())


@pytest.mark.slow
def test_the_wheel_holds_exactly_the_packages_and_their_data(contents):
    wanted = {
        path.relative_to(ROOT).as_posix()
        for folder in ("runner", "models", "solver")
        for path in (ROOT / folder).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts and not path.name.startswith(".")
    }
    assert {name for name in contents if ".dist-info/" not in name} == wanted
    assert {"models/human.xml", "models/clips/run_and_step.toml", "solver/penalty/unit.py"} <= wanted


@pytest.mark.slow
def test_the_wheel_knows_its_command_its_licence_and_nothing_of_the_tests(contents, wheel):
    assert not [name for name in contents if name.split("/")[0] in ("tests", "renders", "benchmarks")]
    (entries,) = (name for name in contents if name.endswith("entry_points.txt"))
    with zipfile.ZipFile(wheel) as archive:
        assert "dynsplines = runner.start:main" in archive.read(entries).decode()
    assert any("licenses/LICENSE" in name for name in contents)


@pytest.mark.slow
def test_an_installed_wheel_finds_its_clips_and_figures(wheel, tmp_path):
    target = tmp_path / "site"
    command = [*PIP, "install", "--no-deps", "--no-index", "--no-compile", "--target", str(target), str(wheel)]
    subprocess.run(command, check=True, capture_output=True, text=True)
    script = f"import sys; sys.path.insert(0, {str(target)!r}); {READ}"
    done = subprocess.run(
        [sys.executable, "-I", "-c", script], cwd=tmp_path, check=True, capture_output=True, text=True
    )
    place, *rest = done.stdout.splitlines()
    assert Path(place) == target / "models" / "__init__.py"
    assert 'figure = "human"' in rest
    assert "'human'" in rest[-1]
    assert (target / "bin" / "dynsplines").is_file()
