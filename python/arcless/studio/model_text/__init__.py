"""Texts of model files as the editor needs them: places of fields, what is wrong, common fields."""
