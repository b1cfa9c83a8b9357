"""Drones that follow a phone, in virtual time, measured against the truth."""
