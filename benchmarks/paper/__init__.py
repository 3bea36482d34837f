"""What the paper claims, measured.

study         the claims, measured
claim         one claim beside what was measured, and the criterion
displacement  the distance of a path from the optimum (appendix C)
nearest       the minimum of an objective nearest to one timeline
barr          the older method that the paper compares itself with: Barr, Currin, Gabriel & Hughes, SIGGRAPH 1992
orientations  seven orientations of one body, the paths through them that the paper compares
"""
