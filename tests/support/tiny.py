"""A figure of two bodies and a clip of three keyframes, solved in a moment, for tests of what surrounds the solver."""

from __future__ import annotations

from pathlib import Path

FIGURE = """
<mujoco model="tiny">
  <compiler angle="degree"/>
  <worldbody>
    <camera name="high" pos="0 -4 1" xyaxes="1 0 0 0 0 1"/>
    <body name="pelvis" pos="0 0 1"><freejoint name="root"/>
      <geom name="trunk" type="sphere" size=".1" mass="4"/>
      <site name="left_toe" pos="0 0 -.1"/>
      <body name="left_shin" pos="0 0 -.2" euler="0 0 30"><joint name="left_knee" type="ball"/>
        <geom name="shin" type="capsule" size=".04" fromto="0 0 0 0 0 -.3" mass="1"/>
      </body>
    </body>
  </worldbody>
</mujoco>
"""

CLIP = """# Three keyframes, the second of them partial.
figure = "tiny.xml"
fps = 20

[solve]
evaluations = 8
frames = 2

[[keyframe]]
time = 0
root.position = [0, 0, 1]
root.rotation = {rotvec = [0, 0, 0]}
joints.left_knee = {rotvec = [0, 0, 0]}

[[keyframe]]
time = 0.2
root.position = [0.1, 0, "free"]
joints.left_knee = {rotvec = [0, 40, 0]}

[[keyframe]]
time = 0.41
root.position = [0.3, 0, 1]
root.rotation = {rotvec = [0, 10, 170]}
joints.left_knee = {rotvec = [0, 0, 0]}
"""

HINGE = """
<mujoco>
  <compiler angle="degree"/>
  <worldbody>
    <body name="rail" pos="0 0 1"><joint name="slide" type="slide" axis="1 0 0"/><geom name="rail" size=".1" mass="1"/>
      <body name="arm" pos="0 0 -.2"><joint name="swing" type="hinge" axis="0 1 0"/>
        <geom name="arm" type="capsule" size=".04" fromto="0 0 0 0 0 -.3" mass="1"/>
      </body>
    </body>
  </worldbody>
  {keys}
</mujoco>
"""


def written(folder: Path, text: str = CLIP, name: str = "tiny.toml") -> Path:
    """A clip file, and beside it the figures that clips of this file ask for."""
    (folder / "tiny.xml").write_text(FIGURE, encoding="utf-8")
    (folder / "hinge.xml").write_text(HINGE.format(keys=""), encoding="utf-8")
    (folder / name).write_text(text, encoding="utf-8")
    return folder / name


def changed(old: str, new: str, text: str = CLIP) -> str:
    """The clip with the first occurrence of a piece of it replaced."""
    assert old in text, f"{old!r} is not in the clip"
    return text.replace(old, new, 1)


def names(folder: Path) -> list[str]:
    """What lies in a folder."""
    return sorted(path.name for path in folder.iterdir())
