"""Files, terminal, pictures: everything of dynamic-splines that touches the world."""
