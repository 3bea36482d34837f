"""Import and export of motions in the file formats of other programs; `formats` lists them."""
