"""Pictures: a motion drawn, by OpenGL or by the CPU alone, into videos and sheets.

rendering  a motion drawn into a file, with every failure raised as a UserError
film       video frames into a video, an animated GIF or a contact sheet; the ending of the target selects which
show       a motion as images: before | after side by side, one of them alone, the keyframes, or the paper's figure 6
stage      pictures of a figure in its scene: the same picture whether OpenGL or the CPU alone draws it
graphics   which renderer works on this machine: EGL, OSMesa, a display, or the CPU alone
raster     a scene of MuJoCo drawn by the CPU alone: depth buffer, four samples a pixel, shadow maps
depth_buffer  triangles seen from a camera or a light: which is nearest in every pixel
lights     lights of a scene, and the shadows that they cast
shading    colours of surfaces and of the sky
camera     a camera that follows the figure smoothly: where it looks from, for every image of the video
ghost      a figure to be drawn in a given shade: the main figure of a picture, or one of several in the same picture
layout     pictures beside each other, and words on a picture. An image is (H, W, 3), uint8; sizes never change
"""
