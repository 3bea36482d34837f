"""A motion as a scene to simulate.

scene     a scene for `mj_step`, with contacts, position actuators and the motion as their targets
tracking  how far `mj_step` of the scene deviates from the motion, and why
"""
