"""Soft constraints on joints, and on how bodies are turned.

bend          knees and elbows
joint_range   the model's ranges
speed         maximum speeds
overshoot     joints with the same value in two neighbouring keyframes
coupling      joints that equality constraints couple
loop_closure  loops that equality constraints close
upright       a trunk at its posed tilt
level         bodies kept upright
self_contact  limbs out of each other
"""
