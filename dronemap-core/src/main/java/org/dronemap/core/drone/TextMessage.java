package org.dronemap.core.drone;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A sentence that the vehicle (or the cloud about it) said.
 *
 * @param about a user whom it names; null: it names nobody
 */
public record TextMessage(
        Severity severity,
        String text,
        Instant at,
        @Nullable String about) {}
