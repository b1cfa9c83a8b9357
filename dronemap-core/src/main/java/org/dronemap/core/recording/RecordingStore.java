package org.dronemap.core.recording;

import java.util.List;
import java.util.Optional;

/** Stores the metadata of recordings, not their bytes; every write returns only after it is durable. */
public interface RecordingStore {
    /** All of them, newest start first. */
    List<Recording> recordings();

    Optional<Recording> recording(String id);

    /** Inserts or replaces. */
    void save(Recording recording);

    /** True when there was one. */
    boolean delete(String id);
}
