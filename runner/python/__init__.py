"""The Python API of `from dynsplines import ...`, on top of the modules that the command line uses."""
