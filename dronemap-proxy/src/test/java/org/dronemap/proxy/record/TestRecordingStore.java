package org.dronemap.proxy.record;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.recording.RecordingStore;

/** What is known of recordings, without a database. */
public final class TestRecordingStore implements RecordingStore {
    private final ConcurrentHashMap<String, Recording> all = new ConcurrentHashMap<>();

    @Override
    public List<Recording> recordings() {
        return all.values().stream()
                .sorted(Comparator.comparing(Recording::start).reversed())
                .toList();
    }

    @Override
    public Optional<Recording> recording(String id) {
        return Optional.ofNullable(all.get(id));
    }

    @Override
    public void save(Recording recording) {
        all.put(recording.id(), recording);
    }

    @Override
    public boolean delete(String id) {
        return all.remove(id) != null;
    }
}
