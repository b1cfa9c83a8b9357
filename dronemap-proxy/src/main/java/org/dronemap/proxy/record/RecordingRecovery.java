package org.dronemap.proxy.record;

import java.io.IOException;
import java.nio.file.Files;
import java.time.Instant;
import java.util.HashSet;
import java.util.Set;
import java.util.function.Function;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.recording.RecordingStore;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Repairs the recordings, on disk and in the store, that a crash of the server left unfinished. */
record RecordingRecovery(RecordingStore store, RecordingFiles files, Function<DroneId, String> names) {
    private static final Logger LOG = LoggerFactory.getLogger(RecordingRecovery.class);
    private static final String CUT = "The server stopped during this recording; it holds what was written until then.";
    private static final String ADOPTED = "Found in the data directory; the server did not know of it any more.";
    private static final String GONE = "Its file is not in the data directory any more.";

    void clear() throws IOException {
        Set<String> known = new HashSet<>();
        for (Recording recording : store.recordings()) {
            known.add(recording.id());
            boolean there = Files.exists(files.path(recording.id()));
            if (!there && (recording.bytes() > 0 || recording.state() == Recording.State.RUNNING)) {
                store.save(gone(recording));
            } else if (there && recording.state() == Recording.State.RUNNING) {
                repair(recording, CUT);
            }
        }
        for (String id : files.ids()) {
            DroneId drone = files.drone(id).orElse(null);
            if (drone != null && !known.contains(id)) {
                Instant changed = Files.getLastModifiedTime(files.path(id)).toInstant();
                repair(
                        new Recording(
                                id,
                                drone,
                                names.apply(drone),
                                changed,
                                changed,
                                0,
                                0,
                                0,
                                Recording.State.INCOMPLETE,
                                ADOPTED),
                        ADOPTED);
            }
        }
    }

    private void repair(Recording recording, String notice) throws IOException {
        Recording repaired = files.repaired(recording, notice);
        store.save(repaired);
        LOG.info("Recording {} holds {} messages: {}", repaired.id(), repaired.frames(), notice);
    }

    private static Recording gone(Recording r) {
        Instant end = r.end();
        return new Recording(
                r.id(),
                r.drone(),
                r.droneName(),
                r.start(),
                end == null ? r.start() : end,
                0,
                0,
                r.drops(),
                Recording.State.INCOMPLETE,
                GONE);
    }
}
