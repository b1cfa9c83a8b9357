package org.dronemap.core.lease;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A user's open request that the current holder hand over control of a drone.
 *
 * @param nanos when, monotonic
 */
public record LeaseRequest(String by, @Nullable String reason, Instant at, long nanos) {}
