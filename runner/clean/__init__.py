"""Cleaning of recordings: sliding, penetration, floating and jumps are removed; the motion is preserved.

repairs    gaps, jumps, duplicate and invalid samples: detected, reported and interpolated
cleaning   a repaired recording, its stances, the motion near it that satisfies them, and its displacement
command    the command `clean`: from a recording's file to a clean one
"""
