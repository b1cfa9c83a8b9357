package org.dronemap.ws.wiring;

/** Port at which the WebSocket stream actually listens; it differs from the setting when that is 0. */
public record StreamPort(int number) {}
