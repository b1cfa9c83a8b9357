package org.dronemap.core.drone;

import java.time.Instant;

/** A sentence that the vehicle (or the cloud about it) said. */
public record TextMessage(Severity severity, String text, Instant at) {}
