"""The figure: a MuJoCo model as links, their motion with exact gradients, and the forces that it requires.

root         the joints by which a model's articulated tree moves in the world
figure       an MjModel as a tree of links, one joint each, and the state that a spline interpolates
forward      forward kinematics of single configurations by MuJoCo
algebra      vectors, rotations and quaternions of many links at many samples, component first
kinematics   motion of the links at samples of a path
adjoint      gradients with respect to that motion, pulled back to the path
dynamics     inverse dynamics of all samples at once, and its adjoint (eqs. 18-21 and appendix A of the paper)
root_wrench  the external wrench at a free root that its motion requires
turns        derivatives by small rotations of joints, converted to the coordinates of the state
wrenches     Jacobian rows of residuals of the links' motion
effort_rows  Jacobian rows of inverse dynamics: joint efforts, and the root's wrench
naming       names of joints and geoms
"""
