"""Formats of other programs, one per module; `exchange.formats` lists them all.

csv_table   CSV: a row per sample with the time and MuJoCo's qpos; a heading names joint and component
arrays      NPZ of plain arrays for MuJoCo, sufficient for playback
mjcf_keys   MJCF with <keyframe>: figure and scene, and a <key> with time, qpos and qvel for every sample
simulate    the same with actuators and contacts, for `mj_step`
mjlab       NPZ of mjlab and BeyondMimic (whole_body_tracking): hinges of a robot, and its bodies in the world
mjlab_csv   CSV from which mjlab and BeyondMimic convert, without a heading
locomujoco  NPZ of LocoMuJoCo: a Trajectory as its `save` writes it, with every array
gmr         pickle of GMR (General Motion Retargeting) and of programs that train on it, such as TWIST
mimickit    pickle of MimicKit: a dict of frames, each a row of numbers for the root and every joint
amass       NPZ of AMASS, only read: motion capture of thousands of people on the SMPL body
bvh         BVH: centimetres, y up, the figure faces z
gltf        glTF 2.0 (.glb): a node per body with its geoms as a mesh, moved by one animation
html        HTML: a page that plays the motion without other files or network access
"""
