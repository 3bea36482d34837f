"""The figures, stages and clips that ship, and the one place that knows how to find them."""
