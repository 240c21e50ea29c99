"""Places of a line and their names: droppers, supports, clamps."""
