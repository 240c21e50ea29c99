"""Settings of a run: motion, steps, record, and assessment."""
