package org.dronemap.store;

import java.util.Comparator;
import org.dronemap.core.recording.Recording;

/** The sort order of recordings, newest first, the same in every kind of store. */
public final class RecordingOrdering {
    public static final Comparator<Recording> NEWEST_FIRST =
            Comparator.comparing(Recording::start).thenComparing(Recording::id).reversed();

    private RecordingOrdering() {}
}
