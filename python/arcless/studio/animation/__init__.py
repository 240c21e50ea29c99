"""The animation of a report: recorded motion, thinned to a size, and the player that shows it."""
