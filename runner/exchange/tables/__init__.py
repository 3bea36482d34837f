"""Tables of numbers by other programs.

table_text  the text of a table, with detection of separator, decimal sign, comments and heading
headings    assignment of columns to components of qpos by name
"""
