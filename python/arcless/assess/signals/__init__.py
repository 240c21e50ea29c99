"""Filters and spectra of recorded forces."""
