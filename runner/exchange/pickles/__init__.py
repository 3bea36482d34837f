"""Pickles of untrusted files as plain data: nothing in them is executed.

plain_pickle    pickles of dicts, lists, numbers, texts and numpy arrays
pickled_arrays  the names that such a pickle may call, and what is made instead
"""
