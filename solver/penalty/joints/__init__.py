"""Soft constraints on joints, and on how bodies are turned.

bend     knees and elbows          joint_range   the model's ranges
coupled  joints that follow        closed        loops that stay closed
upright  a trunk at its posed tilt level         bodies kept upright
self_contact  limbs out of each other
"""
