"""Motion of a line over time, by channels: stored, spooled while it is computed, or made up."""
