"""Maps for skeletons whose names say nothing: written incomplete, filled in, and obeyed, also above the pelvis."""

import re
from pathlib import Path

import numpy as np
import pytest
import shipped
from rich.console import Console

from dynsplines import cli
from dynsplines.clean import command as clean_command
from dynsplines.clip.table import MapTable
from dynsplines.exchange import formats, gaps
from dynsplines.exchange.skeleton import maps, retarget
from dynsplines.exchange.skeleton.bvh_file import read
from dynsplines.exchange.skeleton.captured_skeleton import CapturedSkeleton
from dynsplines.scene.compose import figure_spec
from dynsplines.system.progress import Progress

ROLES = [f"{side}_{part}" for side in ("left", "right") for part in ("upper_arm", "forearm", "thigh", "shin", "foot")]


@pytest.fixture(scope="module")
def walk(tmp_path_factory: pytest.TempPathFactory) -> Path:
    moved = shipped.unsolved("walk_loop")
    return Path(formats.export(moved, "bvh", tmp_path_factory.mktemp("walk") / "walk.bvh"))


def foreign(walk: Path, target: Path, *, on_reference: bool) -> dict[str, str]:
    """Writes the walk with numbers for names, if so under a joint that stands still beside a prop; names by role."""
    text, called = walk.read_text(encoding="utf-8"), dict[str, str]()

    def renamed(found: re.Match[str]) -> str:
        called[found[2]] = f"bone{len(called)}"
        return f"{found[1]} {called[found[2]]}"

    text = re.sub(r"(ROOT|JOINT) (\S+)", renamed, text)
    if on_reference:
        channels = "CHANNELS 3 Zrotation Xrotation Yrotation"
        prop = f"JOINT prop\n{{\nOFFSET 9 9 9\n{channels}\nEnd Site\n{{\nOFFSET 0 1 0\n}}\n}}"
        text = text.replace("ROOT", f"ROOT stage\n{{\nOFFSET 0 0 0\n{channels}\n{prop}\nJOINT", 1)
        head, values = text.split("MOTION\n")
        lines = values.splitlines()
        text = "\n".join([f"{head}}}\nMOTION", *lines[:2], *(f"0 0 0 0 0 0 {line}" for line in lines[2:]), ""])
    target.write_text(text, encoding="utf-8")
    return {role: called[role] for role in ROLES}


@pytest.mark.parametrize("on_reference", [False, True])
def test_a_map_of_limbs_is_enough(walk, tmp_path, on_reference):
    bone_map = foreign(walk, tmp_path / "a.bvh", on_reference=on_reference)
    model = figure_spec("human").compile()
    expected, _ = retarget.onto(CapturedSkeleton.of(read(walk)), model, "walk.bvh")
    with maps.using(MapTable(recording=bone_map)), gaps.allowed():
        found = formats.recording(tmp_path / "a.bvh", model=model)
    assert np.ptp(expected[:, 0]) > 0.3
    np.testing.assert_allclose(found.qpos, expected, atol=1e-5)


@pytest.mark.parametrize("verb", [("retarget", "--to"), ("clean", "--figure")])
def test_an_incomplete_map_is_written_and_named(command, walk, tmp_path, monkeypatch, verb):
    monkeypatch.chdir(tmp_path)
    foreign(walk, tmp_path / "a.bvh", on_reference=False)
    words = (verb[0], "a.bvh", verb[1], "human")
    assert "--map FILE" in command(*words, "--write-map").last
    done = command(*words)
    assert done.code == 2
    assert "--map FILE" in done.last and "--write-map" in done.last
    done = command(*words, "--map", "m.toml", "--write-map")
    assert done.code == 2
    assert done.last.endswith("complete 'm.toml' by hand")
    figure, recording = (tmp_path / "m.toml").read_text(encoding="utf-8").split("[recording]")
    assert 'left_thigh = "left_thigh"' in figure
    assert "# Not found by name. Names without a role: bone0, bone1," in recording
    assert '# left_thigh = ""  # needed' in recording
    assert '# left_upper_arm = ""\n' in recording


def test_a_motion_takes_no_map(command, walk, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert command("import", str(walk), "--figure", "human", "-o", "walk.npz").code == 0
    done = command("clean", "walk.npz", "--map", "human")
    assert done.code == 2
    assert done.last.endswith("leave out --map")


def test_clean_uses_a_map(walk, tmp_path, monkeypatch):
    bone_map = foreign(walk, tmp_path / "a.bvh", on_reference=False)
    lines = "".join(f'{role} = "{name}"\n' for role, name in bone_map.items())
    (tmp_path / "m.toml").write_text(f"[recording]\n{lines}", encoding="utf-8")
    received = list[clean_command.Source]()
    monkeypatch.setattr(clean_command, "run", lambda source, *_, **__: received.append(source))
    cli.clean(tmp_path / "a.bvh", figure="human", map_file=tmp_path / "m.toml")
    read_back = clean_command._read(received[0], clean_command._around(received[0]), Progress(Console(quiet=True)))
    expected, _ = retarget.onto(CapturedSkeleton.of(read(walk)), figure_spec("human").compile(), "walk.bvh")
    np.testing.assert_allclose(read_back.qpos, expected, atol=1e-5)
