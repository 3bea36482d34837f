"""The figure: a MuJoCo model as links, their motion with exact gradients, and the forces that it requires.

model        names, kinematics of single configurations and bounding boxes by MuJoCo
root         the joints by which a model's articulated tree moves in the world
figure       an MjModel as a tree of links, one joint each, and the state that a spline interpolates
algebra      vectors, rotations and quaternions of many links at many samples, component first
kinematics   motion of the links at samples of a path
adjoint      gradients with respect to that motion, pulled back to the path
dynamics     inverse dynamics and its adjoint (eqs. 18-21 and appendix A); the wrench at a free root; size and weight
turns        derivatives by small rotations of joints, converted to the coordinates of the state
wrenches     Jacobian rows of residuals of the links' motion
effort_rows  Jacobian rows of inverse dynamics: joint efforts, and the root's wrench
"""
