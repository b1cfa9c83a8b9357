package org.dronemap.core.link;

import java.time.Instant;

/** An endpoint that somebody added while the server ran; {@code url} is what the links understand. */
public record SavedLink(String id, String url, String addedBy, Instant addedAt) {}
