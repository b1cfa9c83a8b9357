package org.dronemap.core.access;

import org.dronemap.core.stored.Stored;

/** Policy for MAVLink signing of a drone's messages: off, optional or required. */
@Stored(names = "OFF OPTIONAL REQUIRED")
public enum LinkSigningPolicy {
    /** Nothing is checked. With a key the cloud signs all the same: the vehicle may insist on it. */
    OFF,
    /** Signed messages must be signed rightly; unsigned ones pass. */
    OPTIONAL,
    /** Only rightly signed messages speak for the drone. */
    REQUIRED
}
