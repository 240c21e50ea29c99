"""Equation of motion of a pantograph, and its natural modes on the elasticity of a line."""
