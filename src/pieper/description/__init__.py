"""Where arms come from: DH tables, robot files, the catalogue, URDF."""
