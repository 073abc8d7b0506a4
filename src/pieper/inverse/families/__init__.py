"""One solver family per file; each says which arms it takes and prepares its kernel."""
