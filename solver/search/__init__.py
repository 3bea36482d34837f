"""Minimisation of the objective over the variable frames of a timeline.

descent      minimisation on one timeline (steps 3 and 4 of the paper's figure 5)
minimum      the optimiser's interface: arguments, result, stop reasons
newton       Gauss-Newton steps with Levenberg's damping, each a banded solve
quadratic    the model that a step minimises: E to second order, one-sided residuals kept one-sided
refinement   the final stage by NLopt, in variables whitened by that model; the only file that imports NLopt
matrix_free  the alternative for figures of so many joints that Newton's matrices would not fit in memory
restart_criteria  for a search that ended in a poor local minimum
selection    the timeline of least E among several of one clip
"""
