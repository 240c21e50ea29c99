"""Samples of one pantograph: when and where they are, which are good, and pieces without gaps."""
