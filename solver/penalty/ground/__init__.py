"""Soft constraints on contact, grasps and support.

collision   points outside surfaces
attachment  contacts: points that stay at a position, or anywhere without slip
skate       points that slide near a surface
hover       the lowest point stays close to the ground
support     the forces that contacts can supply, and free fall between contacts
"""
