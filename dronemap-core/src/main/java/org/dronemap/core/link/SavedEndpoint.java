package org.dronemap.core.link;

import java.time.Instant;

/** An endpoint for vehicles that an administrator added while the server ran, as stored. */
public record SavedEndpoint(String id, String url, String addedBy, Instant addedAt) {}
