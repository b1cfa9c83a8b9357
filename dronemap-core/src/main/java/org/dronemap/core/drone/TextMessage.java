package org.dronemap.core.drone;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A text message about a drone, from the vehicle itself or from the cloud, for users.
 *
 * @param about a user whom it names; null: it names nobody
 */
public record TextMessage(
        Severity severity,
        String text,
        Instant at,
        @Nullable String about) {}
