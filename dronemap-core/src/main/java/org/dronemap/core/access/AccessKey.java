package org.dronemap.core.access;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A key that a program signs in with; only the SHA-256 hash of its secret is kept.
 *
 * @param parent the key that it was made with, and goes with; null: its owner made it
 * @param lastUsedAt to about a minute; null: not used yet
 */
public record AccessKey(
        String id,
        String label,
        String owner,
        @Nullable String parent,
        KeyRights rights,
        String secretHash,
        Instant createdAt,
        @Nullable Instant lastUsedAt) {}
