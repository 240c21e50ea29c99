"""The study file: what is asked for, and what comes out."""
