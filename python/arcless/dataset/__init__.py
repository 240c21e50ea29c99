"""The dataset of a run: which variables there are, and how it is built."""
