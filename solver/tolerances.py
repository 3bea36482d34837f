"""Tolerances for rounding errors and divisions by zero.

A tolerance that decides more than these is in the module that uses it.
"""

ROUNDING = 1e-9  # [s, m, rad, kg, 1] difference up to which two numbers count as equal
TINY = 1e-12  # [s, m, rad, kg, 1] length of a vector without a direction; least divisor
SMALLEST = 1e-300  # least divisor of numbers without a typical size
