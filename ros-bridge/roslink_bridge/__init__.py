"""Carries a robot of the Robot Operating System to a cloud over ROSLink."""
