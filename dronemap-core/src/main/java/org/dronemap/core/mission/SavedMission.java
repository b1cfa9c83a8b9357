package org.dronemap.core.mission;

import java.time.Instant;

/** A mission of the library, with who changed it last. */
public record SavedMission(String id, String name, Mission mission, String changedBy, Instant changedAt) {}
