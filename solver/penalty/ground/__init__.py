"""Soft constraints on contact, grasps and support.

contact     points outside surfaces
attachment  points that stay at a position: stances, closed loops, targets at single times
rest        points that rest anywhere for an interval
skate       points that slide near a surface
hover       the lowest point stays close to the ground
grasp       a hand on another body
flight      free fall between contacts
support     the forces that contacts can supply
"""
