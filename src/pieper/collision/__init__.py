"""Whether an arm touches itself or what stands around it: distances, gradients, and proofs along a path."""
