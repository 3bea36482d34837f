"""Where more frames are needed, and clips too long for one search.

subdivision     a variable frame where the path is badly approximated: step 5 of the paper's figure 5
euler_lagrange  the Euler-Lagrange residual, its deviation per segment, the weak form
displacement    how far the path is from the optimum, appendix C
limits          a path moved back into hard joint ranges
windows         a long clip window by window: time linear, memory bounded
"""
