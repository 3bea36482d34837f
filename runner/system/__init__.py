"""The machine: files, processes, signals, terminals, memory.

output        the one way to write a file: whole or not at all, under its name only once the disk has it
lock          one program at a time in a folder
scratch       folders for what is needed only while something runs
size_limit    how much a file may come to in memory
archive       memory needed by the arrays of an .npz, from their headers before any is read
cache_folder  the user's folder for what this program could find again: solved clips, and which renderer worked
progress      live progress of long work: a bar on a terminal, plain lines elsewhere, always on stderr
terminal      text for terminals with limited encodings: missing letters are replaced by available ones
mujoco_warnings  MuJoCo's warnings as notes, instead of a log in the current folder
quantity      lengths as people write them: "2cm", "20 mm", "0.02 m"; from Python also a number, of metres
signals       signals that ask a command to end
threads       one thread: on the solver's small matrices more of them only wait for each other, and round another way
workers       worker processes with a tool each, and the results of many items in order
"""
