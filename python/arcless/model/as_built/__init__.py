"""Differences of a line from its design: as built, and in the weather."""
