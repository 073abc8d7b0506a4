"""Every formula and every arm one slip away from a given one."""
