package org.dronemap.store.postgres;

import java.sql.SQLException;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.List;
import java.util.concurrent.locks.ReadWriteLock;
import java.util.concurrent.locks.ReentrantReadWriteLock;
import org.dronemap.core.history.TelemetryPoint;
import org.jspecify.annotations.Nullable;

/**
 * Detects telemetry that is written for a day while that day's table is rebuilt, so that none of it is lost.
 * Thread-safe.
 */
final class DayWriteGuard {
    private final ReadWriteLock lock = new ReentrantReadWriteLock();
    private volatile @Nullable LocalDate watched;
    private volatile boolean touched;

    /** An action on the database. */
    interface DatabaseWork {
        void run() throws SQLException;
    }

    void write(List<TelemetryPoint> batch, DatabaseWork work) throws SQLException {
        lock.readLock().lock();
        try {
            LocalDate day = watched;
            if (day != null && batch.stream().anyMatch(point -> isOf(day, point))) {
                touched = true;
            }
            work.run();
        } finally {
            lock.readLock().unlock();
        }
    }

    private static boolean isOf(LocalDate day, TelemetryPoint point) {
        return LocalDate.ofInstant(point.at(), ZoneOffset.UTC).equals(day);
    }

    /** When this returns all batches that went before are through. */
    void watch(LocalDate day) {
        lock.writeLock().lock();
        try {
            watched = day;
            touched = false;
        } finally {
            lock.writeLock().unlock();
        }
    }

    /** While no batch passes; false, and nothing is done, when one had points of the day since it is watched. */
    boolean whileUntouched(DatabaseWork work) throws SQLException {
        lock.writeLock().lock();
        try {
            if (touched) {
                return false;
            }
            work.run();
            return true;
        } finally {
            lock.writeLock().unlock();
        }
    }
}
