"""A motion as a scene to simulate.

scene     a scene that stands by itself under `mj_step`, with position actuators and the motion as their targets
tracking  how far `mj_step` of the scene leaves the motion, and why
"""
