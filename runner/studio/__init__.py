"""The studio: a clip seen, edited and optimised live, on a page in the browser.

start       the command: a free port, a token, the browser
server      who may speak to it, and what for: the page, and a line to it
session     one clip open, and everybody who looks at it
document    the clip's text, with undo and redo; what nobody has saved lies beside it
numbering   what a page's numbers mean after another page has changed something
sources     what can be opened, as a clip's text
edits/      one function for each way to change the text
outline     what the timeline shows of a text
paths       a motion as the page plays it
posing      the pose that follows a drag
solver      the process that solves, seen from here
solving/    what goes on in it; the figure as the page draws it, curves
glimpse     what a clip showed last, seen at once when it is opened again
files       save, export and render, in the clip's folder
"""
