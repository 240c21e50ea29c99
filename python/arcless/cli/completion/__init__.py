"""Completion at the prompt: what the shell asks this program for, and what it is told."""
