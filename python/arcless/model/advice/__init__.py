"""Advice on models: allowed values that deserve a word to the user."""
