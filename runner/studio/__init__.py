"""The studio: a clip edited and optimised live, on a page in the browser.

launch            the command: a free port, a token, the browser
server            access control: the page with the token, one tab at a time, and its requests
session           one open clip, and what its page shows
document          a clip file's text, with undo and redo, and a copy of unsaved work on the disk
edits/            edits of the text, one function each
outline           the text's content on the timeline
paths             a motion as the page plays it
posing            the pose that follows a drag
footing           contact points of feet, floor and support polygon of a drag
actions           page actions that need the figure
solver            the solver process, as seen from the server
solving/          the solver process itself; the figure as the page draws it, curves
files             saving, export and rendering, in the clip's folder
"""
