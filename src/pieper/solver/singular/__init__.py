"""What is free at a singular pose, and which roots merge there."""
