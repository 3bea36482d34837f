"""Edits of motions, clips and recordings, and the files that they come from and go to.

edits       edits of saved motions, and of clips' tables: mirrored, retimed, trimmed, repeated, joined
files       from files to an edit and back: motions or clips in, a new one out, never overwriting the source unrequested
thinning    `thin`: a recorded motion as few keyframes, with the error bound measured on the result
thin_files  the command `thin`: from a motion's file to the clip of its keyframes, and its summary line
"""
