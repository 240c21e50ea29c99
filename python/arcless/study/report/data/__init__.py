"""Data of a study's report: rows as columns, verdicts by limits, effects of variables."""
