"""A clip that follows a recording.

recording  a clip's [recording]: a motion that the clip follows, and that its keyframes edit
penalties  soft constraints next to the recording: contacts, joint ranges, balance
"""
