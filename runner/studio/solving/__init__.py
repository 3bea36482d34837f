"""The solver process.

process      its start
loop         its loop: texts in; keyframes, improved paths and violations out
stage        the figure as the page draws it
curves       values over time
"""
