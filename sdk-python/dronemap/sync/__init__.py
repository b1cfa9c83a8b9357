"""The same for programs that do not await: each call returns when it is answered."""
