"""Force along the line → orders, spectral lines, deviations by span."""
