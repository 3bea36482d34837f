"""Soft constraints on joints and on orientations of bodies.

bend          knees and elbows
joint_range   the model's joint ranges, and maximum speeds
overshoot     joints with the same value in two neighbouring keyframes
equality      joints coupled and loops closed by equality constraints
upright       bodies that stay upright
self_contact  collisions of a figure with itself
"""
