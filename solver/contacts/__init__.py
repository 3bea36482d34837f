"""When feet stand, when a figure flies, what hands hold, and which gait it has.

thresholds  all thresholds, relative to the size of the figure
"""
