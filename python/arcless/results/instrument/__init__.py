"""A run as an instrumented pantograph would measure it."""
