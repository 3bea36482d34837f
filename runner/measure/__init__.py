"""What a motion is like: measured, judged, charted.

measures     what can be wrong with a motion at some time, each as rows of amounts over time
problems     what is wrong with a motion, worst first: what a user has to know before anything is made of it
bounds       from where on something about a motion is a problem: all bounds stand here
report       what a motion is like, before and after, on a 1 kHz grid: *between* the samples that the optimiser saw
measured     what is measured of a motion, a record each: its name, how it is found, how it is shown
shown        how measures are shown on a screen
grid         a motion on a fine grid
summary      what a solve left, in few words: how it went and what is wrong, without measuring anything at length
penetration  how deep a motion's geoms are in the scene, judged by MuJoCo's own geometry (`mj_geomDistance`)
depths       how deep points of a figure are in surfaces, many points at many times: cheap, for they are spheres
exactness    how exactly a motion goes through its keyframes
swings       how high feet are taken off the ground
hold_report  what a report says of a clip's holds
curves       the numbers behind the charts, kept in the motion file so that `plot` never solves again
chart        charts of a motion: foot height, unit magnitude, Euler-Lagrange deviation over tenths
"""
