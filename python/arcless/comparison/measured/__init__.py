"""Measured test runs against simulated ones: on the line of a run, band by band, tolerances."""
