"""The solver process.

process   where it begins
work      its loop: texts in; keyframes, improving paths, and problems out
foreseen  the speculative result for a text that may follow
stage     the figure as the page draws it
curves    what is drawn over time
"""
