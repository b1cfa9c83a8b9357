"""Calls of REST and SOAP and viewers of the stream, and what they cost, of one version beside another."""
