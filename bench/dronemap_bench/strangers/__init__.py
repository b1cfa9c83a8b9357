"""Measures whether strangers at the WebSocket ports cost others anything; see bench/README.md."""
