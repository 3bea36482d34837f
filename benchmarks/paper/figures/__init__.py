"""New versions of the paper's figures, as charts and pictures, each with its caption.

captioned  a picture with words under it
scenes     figures 6, 7, 11 and 12: figures in a scene
charts     figures 9 and 10: one rotating body's quaternion
drawing    all of them, into a folder
"""
