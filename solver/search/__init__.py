"""Minimisation of the objective over the variable frames of a timeline.

descent        minimisation on one timeline (steps 3 and 4 of the paper's figure 5)
minimum        the interface of optimisers: arguments, result, stop reasons
newton         Gauss-Newton steps with Levenberg's damping, each a banded solve
quadratic      the quadratic model of E that a step minimises, with one-sided residuals
nlopt_methods  the algorithms of NLopt, for the final stage of a search
restarts       detection of poor local minima, and the timeline of least E among several of one clip
"""
