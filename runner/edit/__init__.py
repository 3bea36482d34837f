"""Edits of motions, clips and recordings, and their input and output files.

edits     edits of motions: mirror, retime, trim, repeat
files     edits of files, and of clips' tables
thinning  a motion reduced to few keyframes, with the error measured on the result
"""
