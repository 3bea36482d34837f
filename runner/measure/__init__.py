"""Measurement, violations and charts of a motion.

checks       kinds of violations as rows of amounts over time
overlaps     overlapping moving bodies, by MuJoCo's collision detection
measurement  the amounts of all checks along a motion, measured once
violation    violations, worst first
airborne     figures above the ground without a reason, and sliding feet
bounds       tolerances of violations
report       a motion before and after
quantities   the quantities of one side of a report, also *between* the samples of the optimiser
formatting   lines of a report for the terminal
summary      a short summary of a solve, with its violations
depths       depths of a figure's points in surfaces
exactness    the error of a motion at its keyframes
swings       swings of feet, with their heights
curves       the data of the charts, stored in the motion file so that `plot` never solves again
chart        charts of a motion: foot height, unit magnitude, Euler-Lagrange deviation over tenths
"""
