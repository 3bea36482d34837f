"""Compiled modules are kept while tests run, whatever the environment says: they start Python some hundred times."""

import os
import sys

os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False
