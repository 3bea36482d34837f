"""The studio: a clip edited and optimised live, on a page in the browser.

launch     the command: a free port, a token, the browser
server     access control: the page with the token, one tab at a time, and its requests
session    one open clip, and what its page shows
document   a clip file's text, with undo and redo, and a copy of unsaved work on the disk
blocks     the text as blocks, of which an edit parses one; numbers in the notation of files
edits      edits of the text, one function each
actions    page actions that need the figure
posing     the pose that follows a drag
footing    contact points of feet, floor and support polygon of a drag
files      saving, export and rendering, in the clip's folder
solver     the solver process: its start, and its messages to and from the server
loop       its loop: texts in; keyframes, improved paths and violations out
stage      a clip on the page: the figure, its draggable parts, and the text's content on the timeline
paths      a motion as the page plays it
curves     values over time
"""
