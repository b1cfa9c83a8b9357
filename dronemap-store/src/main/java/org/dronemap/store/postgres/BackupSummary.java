package org.dronemap.store.postgres;

import java.time.Instant;

/** A summary of a backup or restore: schema version, time of the backup, rows in all. */
public record BackupSummary(String schemaVersion, Instant createdAt, long rows) {
    static BackupSummary of(BackupManifest manifest) {
        return new BackupSummary(manifest.schemaVersion(), manifest.createdAt(), manifest.rows());
    }
}
