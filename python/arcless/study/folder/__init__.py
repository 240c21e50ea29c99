"""The folder of a study: journal, table, status, and what earlier versions left."""
