"""A clip file and the problem that it means.

table        the clip file's tables: which keys there are and what they hold, and complaints in the file's own words
load         a clip file (TOML, degrees, names) becomes a problem: figure, keyframes, soft constraints, settings
text         a clip's tables as TOML text again, and keyframes as its tables: the way back of clip.py
file         a motion as a clip's file again
mirror       left and right exchanged in a clip's tables, in the words of the file
constraints  a clip's soft constraints by kind
contacts     a clip's [[contact]] tables: which point rests from when to when, and where if anybody says so
obstacles    the obstacles that a clip's [scene] tables describe
holds        a clip's [[hold]] tables: which site stays where on which body, from when to when
things       things of a clip's scene that move, a crate or a ball
feet         which points of a figure stand on the ground
places       what a clip can name of a figure
placing      keyframes by position
standing     what a partial keyframe leaves free is posed before the search: feet that stand stay where they stand
couplings    equality constraints of a model as a clip keeps them
rotation     rotations as a clip file writes them
pose_report  what a pose violates: equality constraints, joint ranges, the floor, bodies in each other
starter      a clip to begin with, for any model
follow/      a clip that follows a recording, and whose keyframes edit it
"""
