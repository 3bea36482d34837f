"""Edits of motions, clips and recordings, and the files that they come from and go to.

edits       edits of saved motions, and of clips' tables: mirrored, retimed, trimmed, repeated, joined
files       from files to an edit and back: motions or clips in, a new one out, never over what it came from unasked
thinning    `thin`: a recorded motion as few keyframes, with the guarantee measured on what comes out
thin_files  the command `thin`: from a motion's file to the clip of its keyframes, and what is said of it
"""
