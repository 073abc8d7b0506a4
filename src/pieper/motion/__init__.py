"""From pose to pose and from posture to posture."""
