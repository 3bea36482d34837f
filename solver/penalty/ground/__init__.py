"""Soft constraints on what the figure touches, holds and is carried by.

contact   points out of surfaces      planted    points that stay on a spot
resting   points that rest anywhere   skate      points that slide near a surface
grounded  the lowest point stays low  placement  points that are to be somewhere at an instant
hold      a hand on another body      carried    bodies that hands carry
footing   what carries the figure     flight     free fall in between
support   what contacts can supply
"""
