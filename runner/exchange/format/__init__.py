"""One format of others a file; `formats` in the folder above lists them all.

csv_table   CSV: a row an instant, the time and MuJoCo's qpos, under a heading that names joint and component
arrays      NPZ of plain arrays for MuJoCo, with everything needed for playback
mjcf_keys   MJCF with <keyframe>: the figure and its scene, and a <key> with time, qpos and qvel for every instant
mjlab       NPZ of mjlab and BeyondMimic (whole_body_tracking): a robot's hinges, and its bodies in the world
mjlab_csv   CSV that mjlab and BeyondMimic convert from, without a heading
locomujoco  NPZ of LocoMuJoCo: a Trajectory as its `save` writes it and its `load` reads it, every array filled in
gmr         pickle of GMR (General Motion Retargeting) and what is trained on it, such as TWIST
mimickit    pickle of MimicKit: a dict of frames, the root and every joint of a character as numbers in a row
deepmimic   JSON of DeepMimic (and its data/motions/*.txt): the frames of its humanoid, y up
amass       NPZ of AMASS, read: motion capture of thousands of people on the SMPL body
bvh         BVH: centimetres, y up, the figure looks along z
gltf        glTF 2.0 (.glb): a node a body with its geoms as a mesh, moved by one animation
usd         USD (.usd, .usda, .usdc): a Xform a body, moved at every time code
html        HTML: the motion in a page of its own that plays it, from the disk and without any other file or address
"""
