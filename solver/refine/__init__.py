"""Refinement: insertion of frames, error estimates, parts of clips.

subdivision  variable frames where the path is badly approximated (step 5 of the paper's figure 5), by the
             Euler-Lagrange residual or the weak form
warm_start   an earlier solution mapped to edited keyframes
parts        parts of a clip as separate clips: near an edit, or the windows of a long clip
"""
