"""Rendering of motions, by OpenGL or by the CPU alone, to videos and pictures.

film      video frames into a video, an animated GIF or a contact sheet
show      a motion as images or a file: before and after side by side, the keyframes, or the paper's figure 6
stage     pictures of a figure in its scene, the same by OpenGL and by the CPU
graphics  selection of the renderer: OpenGL, or the CPU alone
raster    software rendering: depth buffer, four samples per pixel
camera    a camera that follows the figure smoothly
"""
