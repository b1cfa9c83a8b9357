"""Parts of end-to-end tests: the server, simulated vehicles, a tap on the wire, peers of our own."""
