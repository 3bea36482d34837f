"""The machine: files, processes, signals, terminals, memory.

output        atomic writing of files, and locks of files
size_limit    limit on the memory that a file may need
progress      progress of long work: a bar on a terminal, plain lines elsewhere, always on stderr
mujoco_warnings  MuJoCo's warnings as notes
quantity      lengths and speeds with units: "2cm", "20 mm", "0.02 m"
signals       signals that end a command
threads       one thread of linear algebra, for speed and reproducible results
workers       worker processes, and the results of many items in order
exit_status   exit codes and error messages
"""
