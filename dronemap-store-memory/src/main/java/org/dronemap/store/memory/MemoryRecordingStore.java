package org.dronemap.store.memory;

import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.recording.RecordingStore;
import org.dronemap.store.RecordingOrdering;
import org.dronemap.store.StoredInstant;

/**
 * Keeps descriptions of recordings, not their bytes, in memory, for tests. Thread-safe: every method holds the object's
 * lock.
 */
public final class MemoryRecordingStore implements RecordingStore {
    private final Map<String, Recording> recordings = new HashMap<>();

    @Override
    public synchronized List<Recording> recordings() {
        return recordings.values().stream()
                .sorted(RecordingOrdering.NEWEST_FIRST)
                .toList();
    }

    @Override
    public synchronized Optional<Recording> recording(String id) {
        return Optional.ofNullable(recordings.get(id));
    }

    @Override
    public synchronized void save(Recording recording) {
        Instant end = recording.end();
        recordings.put(
                recording.id(),
                new Recording(
                        recording.id(),
                        recording.drone(),
                        recording.droneName(),
                        StoredInstant.of(recording.start()),
                        end == null ? null : StoredInstant.of(end),
                        recording.bytes(),
                        recording.frames(),
                        recording.drops(),
                        recording.state(),
                        recording.notice()));
    }

    @Override
    public synchronized boolean delete(String id) {
        return recordings.remove(id) != null;
    }
}
