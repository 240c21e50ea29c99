"""Figures of a study: outputs over variables, two variables at a time, maps, indices."""
