"""Measurement, violations and charts of a motion.

checks       what is measured for most kinds of violations: quantities, and how far each exceeds its limit
overlaps     overlapping moving bodies, by MuJoCo's collision detection
measurement  the amounts of all checks along a motion, measured once
violation    violations, worst first
ground       figures that float above the ground, and feet that slide or drag on it
bounds       tolerances of violations
report       a motion before and after solving
quantities   the quantities of one column of a report, also *between* the samples of the optimiser
formatting   lines of a report for the terminal
depths       depths of a figure's points in surfaces
chart        the chart of a motion's measured amounts over time, relative to the bounds of violations
"""
