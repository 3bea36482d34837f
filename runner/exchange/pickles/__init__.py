"""Pickles of untrusted files, read as plain data without executing anything.

plain_pickle    pickles of dicts, lists, numbers, texts and NumPy arrays
pickled_arrays  safe constructors for the names that such a pickle may call
"""
