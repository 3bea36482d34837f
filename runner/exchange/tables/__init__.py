"""Tables of numbers by other programs.

table_text  the text of a table: separator, decimal sign, comments and heading are detected
headings    which columns are which components of qpos, by their names
"""
