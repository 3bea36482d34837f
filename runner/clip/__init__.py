"""A clip file and the problem that it specifies: parse, pose, build.

load          the three stages in order, from a file, text, arrays, a model or a solved motion
parse         first stage: TOML text into checked tables
pose          second stage: keyframe tables into keyframes of a figure
build         last stage: keyframes into a problem with soft constraints
table         the tables of a clip's file: keys and values
table_errors  errors of the tables in terms of the file
text          tables as TOML text, keyframes as tables, and motions as clip files
mirror        left and right exchanged in a clip's tables
context       the inputs of soft constraints, inferred from keyframes and tables
kinds         the kinds of soft constraint
contacts      the [[contact]] and [[grasp]] tables
starter       a starting clip for any model
posing/       positions, roots and feet of keyframes
tracking/     a clip that follows a recording
"""
