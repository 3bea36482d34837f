"""Soft constraints on the motion of the figure.

covariant  angular acceleration
root       acceleration of the root and of slides
unit       length of quaternions
posture    angular velocity, in addition to acceleration
peak       the largest angular acceleration
torque     joint torques, by inverse dynamics
cycle      the gait cycle inferred from keyframes
tracking   the recorded motion
"""
