"""Measurement, violations and charts of a motion.

checks       what is measured for most kinds of violations: quantities, and how far each exceeds its limit
measurement  the amounts of all checks along a motion, measured once
violation    violations, worst first
ground       what the ground does not carry: floating, sliding, missing forces, lost balance
bounds       violations and their bounds
report       a motion before and after solving, also *between* the samples of the optimiser, and its lines
depths       depths of a figure's points in surfaces, and of its bodies in each other
chart        the chart of a motion's measured amounts over time, relative to the bounds of violations
"""
