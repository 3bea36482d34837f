"""Pickles of strangers as plain data: nothing in them is run.

plain_pickle    pickles of plain data: dicts, lists, numbers, texts and numpy arrays
pickle_program  the program that a pickle is, run here step by step on plain data, with no way out to anything else
pickled_arrays  numpy's arrays as pickles spell them, made from bytes whose count is checked, of a few fixed types
"""
