"""Designs that choose their variants, and runs that are stopped early."""
