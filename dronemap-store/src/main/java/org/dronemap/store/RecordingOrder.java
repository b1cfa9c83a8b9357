package org.dronemap.store;

import java.util.Comparator;
import org.dronemap.core.recording.Recording;

/** In which order recordings are listed, in every adapter alike. */
public final class RecordingOrder {
    public static final Comparator<Recording> NEWEST_FIRST =
            Comparator.comparing(Recording::start).thenComparing(Recording::id).reversed();

    private RecordingOrder() {}
}
