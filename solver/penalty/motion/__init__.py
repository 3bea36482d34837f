"""Soft constraints on the motion of the figure.

acceleration  of joints, roots and slides, the largest ones, and the length of quaternions
posture       angular velocity, in addition to acceleration
torque        joint torques, by inverse dynamics
cycle         the gait cycle inferred from keyframes
tracking      the recorded motion
people        how people move between two keyframes, predicted by small networks
prior         the motion that people prefer
"""
