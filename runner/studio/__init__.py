"""The studio: a clip edited and optimised live, on a page in the browser.

launch            the command: a free port, a token, the browser
server            access control: pages with the token, and their connections
session           one open clip, shared by all pages
document          the clip's text, with undo and redo; unsaved work is written next to it
revision_map      indices of an older revision, after another page has changed the text
sources           files that can be opened, as a clip's text
edits/            one function for each way to change the text
outline           the text's content on the timeline
paths             a motion as the page plays it
posing            the pose that follows a drag
footing           contact points of feet, floor and support polygon of a drag
solver            the solver process, as seen from the server
solving/          the solver process itself; the figure as the page draws it, curves
startup_snapshot  the last view of a clip, shown at once when it is opened again
files             save, export and render, in the clip's folder
"""
