"""Edits of motions, clips and recordings, and their input and output files.

edits       edits of saved motions and of clips' tables: mirror, retime, trim, repeat, join
files       edits of files
thinning    a recorded motion reduced to few keyframes, with the error measured on the result
thin_files  the command `thin`
"""
