package org.dronemap.core.drone;

import java.time.Instant;

/** A part of a drone's state that its vehicle does not tell any more, though it is heard, and when it last did. */
public record OutdatedPart(StatePart part, Instant lastHeard) {}
