"""What a file may leave to the user to say, in words that fit the command line and Python alike."""

FIGURE = "say whose it is: --figure, or figure= in Python"
RATE = "say the rate: --fps, or fps= in Python"
UNIT = "say the unit: --scale, or scale= in Python"
MAP = "name it in a map, `retarget --map FILE`; --write-map writes one to fill in"
FORMAT = "give --from, or format= in Python"
