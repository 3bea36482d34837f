"""The scene: figure and stage made one model, and what a model may read.

compose          figure and stage become one model
obstacle         obstacles of a clip's scene: boxes, spheres, capsules and cylinders in metres, as geoms of the stage
appearance       materials for a model that has none
lighting         whether a model's own lamps light its figure wherever it goes
framing          how large a figure is and where
assets           files that a model refers to, meshes, images, height fields and skins, brought along as bytes
model_files      files that an MJCF file refers to, from its text, before MuJoCo reads any of them
mjcf_size        what an MJCF model comes to in memory, estimated from its text before MuJoCo reads it
file_access      whether a model may refer to files outside its own folder
configuration    checks of configurations of a model, MuJoCo's qpos, for untrusted input
model_inputs     a model given to the Python API: a name, a path, MJCF text, an MjSpec or an MjModel
urdf             the root link of a URDF file
triangles        visible geoms of a model, how they look, and the triangles that draw them
mujoco_versions  what MuJoCo calls by other names in its older versions
"""
