"""A line as tables, as Excel or CSV files: its spans, supports, droppers, and what stands along."""
