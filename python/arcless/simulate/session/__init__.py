"""A line stepped from outside, in real time."""
