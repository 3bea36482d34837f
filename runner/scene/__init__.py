"""The scene: figure and stage as one model, and the files that a model may read.

compose          figure, stage and obstacles as one model
framing          size and position of a figure, for cameras
assets           files to which a model refers (meshes, images, height fields, skins), as bytes
file_access      files to which an MJCF file refers, from its text, and whether they may be outside its folder
configuration    checks of configurations qpos, for untrusted input
roles            which part of the body a joint is, by its name and its position in the tree
model_notes      notes on models that the solver does not fully support
triangles        visible geoms of a model, their appearance, and their triangles
mujoco_versions  names that differ between MuJoCo's versions
"""
