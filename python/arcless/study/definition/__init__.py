"""The study file: variables, design, outputs and execution."""
