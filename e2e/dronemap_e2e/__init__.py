"""Parts of end-to-end tests: the server, simulated vehicles, a recorder of messages, peers of our own."""
