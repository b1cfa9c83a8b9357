"""Measures a whole Dronemap server under load, from outside, over its public ports."""
