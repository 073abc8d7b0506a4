"""Programs as controllers write them: one file a dialect, what is written is read back."""
