"""Parts of a line → rows of the tables, and the whole mesh."""
