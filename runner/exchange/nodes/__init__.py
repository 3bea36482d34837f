"""Scene files with nodes placed in the world, as in glTF and USD, read as skeletons.

node_tree  nodes of one tree, at rest and in motion, and the skeleton that they form
gltf_file  the nodes that an animation of a glTF or VRM file moves
usd_file   the nodes that move on a USD stage
"""
