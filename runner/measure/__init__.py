"""What a motion is like: measured, judged, charted.

checks       kinds of violations as rows of amounts over time
overlaps     moving bodies in each other, by MuJoCo's collision detection
measurement  the amounts of all checks along a motion, measured once
violation    violations, worst first
bounds       tolerances of violations
report       a motion before and after
quantities   what a report has of one side, of violations and *between* the samples that the optimiser saw
formatting   lines of a report on a screen
summary      a solve in few words: how it went, and its violations
depths       depths of a figure's points in surfaces, many points at many times: cheap, for they are spheres
exactness    how exactly a motion goes through its keyframes
swings       how high feet are taken off the ground
curves       the numbers behind the charts, in the motion file so that `plot` never solves again
chart        charts of a motion: foot height, unit magnitude, Euler-Lagrange deviation over tenths
"""
