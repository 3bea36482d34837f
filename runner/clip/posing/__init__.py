"""Posing of keyframes before the search: goals by position, and unspecified entries.

places         points, bodies and roots by name, and the soles
placement      joint values from specified positions
standing_feet  stances of feet in partial keyframes
grounding      placing of keyframes on the ground
notes          notes on unmet goals, ambiguous roots, and whole turns of keyframes that the motion omits
"""
