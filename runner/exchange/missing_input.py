"""What to supply when a file lacks it, worded for the command line and Python alike."""

FIGURE = "name the figure: --figure, or figure= in Python"
RATE = "give the rate: --fps, or fps= in Python"
UNIT = "give the unit: --scale, or scale= in Python"
MAP = "name it in a map, `retarget --map FILE`; --write-map writes one to fill in"
FORMAT = "give --from, or format= in Python"
SKELETON = "to transfer it to another figure, export a skeleton with its own figure (.bvh), and retarget that"
