"""Keyframes by position, and what partial keyframes leave free: posed before the search.

places     names of points and bodies   placing   places that keyframes give become joints
feet       the soles' points            standing  feet that stand stay where they stand
rotation   rotations as a clip has them couplings joints that others make follow
turns      turns that keyframes write and no motion makes
closing    poses moved onto a model's equality constraints
rooting    what places a root, on a free joint or on slides and hinges
pose_report  violations of a pose: equality constraints, joint ranges, the floor, bodies in each other
"""
