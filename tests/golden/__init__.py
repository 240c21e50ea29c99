"""Digests of results that tell a change of any bit; they say nothing about what is right."""
