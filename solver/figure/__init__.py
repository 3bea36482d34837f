"""The figure: a MuJoCo model as links, their motion with exact gradients, and the forces that it takes.

root           the joints that carry a model's articulated tree, wherever the model lists it
figure         an MjModel as a tree of links, one joint each, and the state that a spline runs through
algebra        vectors, rotations and quaternions of many links at many samples, component first
kinematics     samples of a path as motion of the links
adjoint        gradients with respect to that motion, pulled back to the path
dynamics       inverse dynamics of all samples at once, and its adjoint; eqs. 18-21 and appendix A of the paper
wrench         the wrench at a free root: what must push the figure from outside for it to move as it does
turns          what a change by small turns of joints means for the coordinates of the state
wrenches       Jacobian rows of what changes as links move
effort_rows    Jacobian rows of inverse dynamics: of joints' efforts, and of the root's wrench
naming         names of geoms in messages
"""
