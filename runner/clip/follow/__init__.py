"""A clip that follows a recording.

recording  a clip's [recording]: a motion that the clip follows, and that its keyframes edit
keeping    constraints kept while following a recording: contacts, joint ranges, balance
"""
