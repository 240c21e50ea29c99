"""Pantographs that are FMUs: their process, and their coupling with the steps of the line."""
