"""A clip that follows a recording.

recording  a clip's [recording]: the motion that the clip follows and its keyframes edit
penalties  soft constraints besides the recording: contacts, joint ranges, balance
"""
