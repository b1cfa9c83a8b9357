"""Makes the documentation site of Dronemap."""
