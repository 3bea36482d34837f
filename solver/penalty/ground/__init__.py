"""Soft constraints on contact, grasps and support.

contact    points outside surfaces
stance     points that stay in one place between two keyframes
rest       points that rest anywhere for an interval
skate      points that slide near a surface
hover      the lowest point stays close to the ground
placement  points with a target at an instant
grasp      a hand on another body
flight     free fall between contacts
support    the forces that contacts can supply
"""
