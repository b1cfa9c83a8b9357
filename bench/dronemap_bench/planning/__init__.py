"""Measures the planner on published instances, beside public solvers."""
