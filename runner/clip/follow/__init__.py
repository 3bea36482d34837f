"""A clip that follows a recording.

recording  a clip's [recording]: a motion that the clip follows, and that its keyframes edit
keeping    what a motion that follows a recording is to keep beside it: contacts, ranges, balance
"""
