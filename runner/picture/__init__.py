"""Pictures: a motion drawn, by OpenGL or by rays, into videos and sheets.

rendering  a motion drawn into a file, with whatever goes wrong told as the user's error
film       images into a video, an animated GIF or a contact sheet; the ending of the target says which
show       a motion as images: before | after side by side, one of them alone, the keyframes, or the paper's figure 6
stage      pictures of a figure in its scene: the same picture whether OpenGL or MuJoCo's rays draw it
graphics   which renderer works on this machine: EGL, OSMesa, a display, or MuJoCo's own rays
rays       pictures without any GL library: rays cast by MuJoCo, shaded here
shading    what the rays' pictures are made of: a model's surfaces, lights and sky as numbers
caster     rays cast into a model: by `mujoco.batch`, or one origin at a time by a MuJoCo that is older than 4
camera     a camera that follows the figure smoothly: where it looks from, for every image of the video
ghost      a figure to be drawn in a given shade: the main figure of a picture, or one of several in the same picture
layout     pictures beside each other, and words on a picture. An image is (H, W, 3), uint8; sizes never change
"""
