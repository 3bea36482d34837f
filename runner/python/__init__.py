"""What `from dynsplines import ...` gives to users of Python, on top of the modules that the command line uses."""
