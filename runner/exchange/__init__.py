"""Motion to and from the files of others: one format a file, all of them listed in `formats`."""
