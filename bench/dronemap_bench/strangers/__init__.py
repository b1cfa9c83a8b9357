"""Whether strangers at the WebSocket ports cost the others anything; see bench/README.md."""
