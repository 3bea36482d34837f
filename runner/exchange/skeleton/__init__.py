"""Skeletons of motion capture: reading, interpretation, and retargeting to figures.

bvh_file         the text of a BVH file (Biovision hierarchy), to and from numbers
hierarchy        bodies in the convention of animation
captured_skeleton  a captured skeleton in metres, z up, facing x where it stands straight
captured_figure  a captured skeleton as a new figure
retarget         a captured skeleton's motion on another figure
"""
