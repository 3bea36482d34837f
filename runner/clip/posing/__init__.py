"""Posing of keyframes before the search: goals by position, and unspecified entries.

places         points and bodies by name, and the soles
placement      joint values from specified positions
unmet_goals    notes on positions out of reach
standing_feet  stances of feet in partial keyframes
stepping       the initial guess of clips with footsteps
grounding      placing of keyframes on the ground
keyframe_notes notes on ambiguous roots, and on whole turns of keyframes that the motion omits
root_entries   entries of roots
"""
