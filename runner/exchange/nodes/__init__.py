"""Scene files, read: nodes that are placed in the world, as glTF and USD have them, as skeletons.

node_tree  nodes of one tree, at rest and moving, and the skeleton that they are
gltf_file  the nodes that an animation of a glTF or VRM file moves
usd_file   the nodes that move on a USD stage
"""
