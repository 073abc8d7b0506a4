"""An arm compared with what an independent toolbox makes of it."""
