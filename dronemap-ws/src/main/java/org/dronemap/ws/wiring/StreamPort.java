package org.dronemap.ws.wiring;

/** Where the stream listens in fact; another number than the setting when that is 0. */
public record StreamPort(int number) {}
