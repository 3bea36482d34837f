"""Soft constraints on how the figure moves.

covariant  angular acceleration      root     acceleration of the root and of slides
unit       quaternions' length       posture  angular velocity beside acceleration
peak       the largest acceleration  torque   what joints must do, by inverse dynamics
cycle      the gait cycle inferred from keyframes
tracking   the recorded motion
"""
