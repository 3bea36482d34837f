"""A clip that follows a recording.

recording  a clip's [recording]: the motion that the clip follows and its keyframes edit
problem    the problem of following it: frames, stances, soft constraints
"""
