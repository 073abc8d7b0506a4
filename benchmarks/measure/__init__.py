"""What is measured: speed beside peers, recall, completeness, plans, the workbench."""
