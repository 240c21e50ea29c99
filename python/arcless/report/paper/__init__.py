"""Reports on paper: a document of texts, tables and figures → PDF, typeset by typst."""
