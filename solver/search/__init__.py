"""The search: variable frames moved to the nearest minimum of the objective.

descent      steps 3 and 4 of the paper's figure 5 on one timeline
minimum      what a minimisation is: how it is asked for, what comes out, why it ended
newton       Gauss-Newton steps with Levenberg's damping, each a banded solve
quadratic    the model that a step minimises: E to second order, one-sided residuals kept one-sided
refinement   the last stage by NLopt, in variables in which that model is a sphere; the only file that knows NLopt
matrix_free  the same for figures of so many joints that Newton's matrices would fill the memory
astray       whether a search ended in a heap
judgement    which of several timelines of one clip is best
"""
