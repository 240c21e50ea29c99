"""Names, files and plain data → validated models, changed copies, schemas."""
