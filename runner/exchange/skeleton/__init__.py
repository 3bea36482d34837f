"""Captured people: skeletons read, understood, and put on a figure.

bvh_file         the text of a BVH file, Biovision's hierarchy and motion, to numbers and back
body_root        a skeleton from its body's root on: the parents above the pelvis are folded into it
hierarchy        bodies as animators have them
roles            which part of a body a joint is, by its name and its place in the tree: for skeletons of many makers
captured_skeleton  a captured skeleton in our axes: metres, z up, looking along x where it stands straight
captured_figure  a captured skeleton as a figure of its own
humanoid         a figure as a person: ball joints by the names that skeletons of motion capture share
smpl             the SMPL body: its 22 joints, their places in the mean shape, and the axes and unit of recordings
root_motion      the root of a figure, moved on a free joint or on slides
up_axis          which way is up in the rest pose of a figure
retarget         a captured skeleton's motion on another figure
hinge_joints     ball joints as three hinges each, for formats and simulators that know hinges only
"""
