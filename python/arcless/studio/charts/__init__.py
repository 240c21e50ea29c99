"""Series, figures, comparisons and explanations of runs as plain data for the page."""
