"""Writes the part of the client that follows from the description of REST."""
