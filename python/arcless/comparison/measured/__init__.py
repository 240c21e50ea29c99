"""Measured test runs beside simulated ones: placed on the line, band by band, accepted or not."""
