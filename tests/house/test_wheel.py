"""The wheel holds the package with its data and nothing else, and works from an empty folder."""

import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
BUILD = "import sys; from setuptools.build_meta import build_wheel; build_wheel(sys.argv[1])"
READ = (
    "from dynsplines import load, models; import dynsplines.solver; print(models.__file__);"
    "print(models.clip_text('run_and_step')); print(load('run_and_step')); print(models.figures())"
)
PACKAGES = {"runner": "dynsplines", "models": "dynsplines/models", "solver": "dynsplines/solver"}


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder, source = tmp_path_factory.mktemp("wheel"), tmp_path_factory.mktemp("source")
    for name in (*PACKAGES, "pyproject.toml", "README.md", "LICENSE", "MANIFEST.in"):
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, source / name)
        else:
            shutil.copy(ROOT / name, source / name)
    command = [sys.executable, "-c", BUILD, str(folder)]
    subprocess.run(command, cwd=source, check=True, capture_output=True, text=True)
    (built,) = folder.glob("*.whl")
    return built


@pytest.mark.slow
def test_the_wheel_holds_exactly_the_packages_their_data_the_command_and_the_licence(wheel):
    wanted = {
        f"{package}/{path.relative_to(ROOT / folder).as_posix()}"
        for folder, package in PACKAGES.items()
        for path in (ROOT / folder).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts and not path.name.startswith(".")
    }
    with zipfile.ZipFile(wheel) as archive:
        contents = {name: archive.read(name) for name in archive.namelist()}
    assert {name for name in contents if ".dist-info/" not in name} == wanted
    named = ("py.typed", "models/human.xml", "models/clips/run_and_step.toml", "solver/penalty/motion/acceleration.py")
    assert {f"dynsplines/{name}" for name in named} <= wanted
    about = {name.split(".dist-info/")[1]: data.decode() for name, data in contents.items() if ".dist-info/" in name}
    assert about["top_level.txt"].split() == ["dynsplines"]
    assert "dynsplines = dynsplines.__main__:main" in about["entry_points.txt"]
    assert any("licenses/LICENSE" in name for name in about)


@pytest.mark.slow
def test_a_wheel_works_next_to_a_project_with_folders_of_the_same_names(wheel, tmp_path):
    target = tmp_path / "site"
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(target)
    project = tmp_path / "project"
    for name in PACKAGES:
        (project / name).mkdir(parents=True)
        (project / name / "__init__.py").write_text(f"raise ImportError('the project's own {name}')")
    script = f"import sys; sys.path[:0] = [{str(project)!r}, {str(target)!r}]; {READ}"
    command = [sys.executable, "-I", "-c", script]
    done = subprocess.run(command, cwd=project, check=True, capture_output=True, text=True)
    place, *rest = done.stdout.splitlines()
    assert Path(place) == target / "dynsplines" / "models" / "__init__.py"
    assert 'figure = "human"' in rest
    assert "'human'" in rest[-1]
