package org.dronemap.store.postgres;

import java.time.Instant;

/** What was backed up or restored: the schema's version, when the backup was made, rows in all. */
public record BackupSummary(String schemaVersion, Instant createdAt, long rows) {
    static BackupSummary of(BackupManifest manifest) {
        return new BackupSummary(manifest.schemaVersion(), manifest.createdAt(), manifest.rows());
    }
}
