"""What goes on in the process that solves.

process  where it begins
work     its life: texts in; keyframes, better and better paths, and what is wrong with them out
stage    the figure as the page draws it
curves   what is drawn over time
"""
