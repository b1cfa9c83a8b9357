"""The command line of Dronemap."""
