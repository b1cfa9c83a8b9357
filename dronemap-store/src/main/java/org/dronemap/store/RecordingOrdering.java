package org.dronemap.store;

import java.util.Comparator;
import org.dronemap.core.recording.Recording;

/** The sort order of recordings, the same in every adapter. */
public final class RecordingOrdering {
    public static final Comparator<Recording> NEWEST_FIRST =
            Comparator.comparing(Recording::start).thenComparing(Recording::id).reversed();

    private RecordingOrdering() {}
}
