"""What goes on in the process that solves.

process   where it begins
work      its life: texts in; keyframes, better and better paths, and what is wrong with them out
foreseen  what a text would come to that may be said next
stage     the figure as the page draws it
curves    what is drawn over time
"""
