package org.dronemap.core.lease;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A user asks the holder for control.
 *
 * @param nanos when, monotonic
 */
public record LeaseRequest(String by, @Nullable String reason, Instant at, long nanos) {}
