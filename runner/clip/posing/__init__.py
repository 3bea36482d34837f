"""Keyframes by position, and what partial keyframes leave free: posed before the search.

places         names of points and bodies
placement      joints from the positions that keyframes specify
feet           the soles' points
standing_feet  feet that stand stay in place
grounding      keyframes put down on the ground
rotation       rotations as a clip has them
couplings      joints that equality constraints couple
full_turns     whole turns of keyframes that the motion lacks
equalities     poses moved onto a model's equality constraints
root_entries   the entries that place a root, on a free joint or on slides and hinges
pose_report    violations of a pose: equality constraints, joint ranges, the floor, bodies in each other
"""
