"""Wires of a result as figures need them: nodes at rest, recorded motion, velocity."""
