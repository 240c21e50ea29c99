"""Parts that a line is described by: wires, supports, spans, heights, curves."""
