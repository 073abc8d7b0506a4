"""The inverse derived step by step, with every choice written down, and checked."""
