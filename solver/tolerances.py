"""Tolerances for rounding errors and divisions by zero, and limits of Newton's method.

A tolerance that decides more than these is in the module that uses it.
"""

ROUNDING = 1e-9  # [s, m, rad, kg, 1] difference up to which two numbers count as equal
TINY = 1e-12  # [s, m, rad, kg, 1] length of a vector without a direction; least divisor
NEGLIGIBLE = 1e-3  # [s, m, rad, 1] difference of results that does not matter, and relative difference of costs
SINGLE = 1e-6  # [s, m, rad, kg, 1] the same for numbers that were in single precision, or are results of iterations
LAST_STEP = 1e-14  # [1] relative size of a Newton step that is the last
NEWTON_STEPS = 60  # maximum number of Newton steps
SMALLEST = 1e-300  # least divisor of numbers without a typical size
