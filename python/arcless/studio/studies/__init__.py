"""Studies: what can be varied, the study file, rows as they come, a row as a scenario."""
