"""Figures and series as plain data: pyramids of extremes, layers ready for JSON, bytes."""
