"""Differences between Linux, macOS and Windows: each module gives one thing on all of them."""
