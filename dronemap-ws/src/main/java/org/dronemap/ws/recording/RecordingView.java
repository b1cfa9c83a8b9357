package org.dronemap.ws.recording;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.recording.RecordingArchive;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/**
 * A recording of the messages exchanged with a vehicle, as clients see it.
 *
 * @param end null while it goes on
 * @param seconds from the first message to the last one
 * @param drops messages that are missing
 * @param state running, complete, incomplete
 * @param notice why it is not complete; null otherwise
 */
@Schema(name = "RecordingView")
public record RecordingView(
        String id,
        String drone,
        String droneName,
        Instant start,
        @Nullable Instant end,
        @Nullable Double seconds,
        long bytes,
        long frames,
        long drops,
        @EnumValues(Recording.State.class) String state,
        @Nullable String notice) {

    /** All that may be seen, and the room that recordings take. */
    @Schema(name = "RecordingPage")
    public record Page(List<RecordingView> recordings, RoomView room) {}

    /** Disk space and retention of the server's recordings: present use and limits. */
    @Schema(name = "RecordingRoomView")
    public record RoomView(
            long usedBytes,
            long mostBytes,
            int keepDays,
            long removed,
            @Nullable String notice) {
        static RoomView of(RecordingArchive.DiskUsage room) {
            return new RoomView(room.usedBytes(), room.mostBytes(), room.keepDays(), room.removed(), room.notice());
        }
    }

    static RecordingView of(Recording recording) {
        Instant end = recording.end();
        return new RecordingView(
                recording.id(),
                recording.drone().value(),
                recording.droneName(),
                recording.start(),
                end,
                end == null ? null : Duration.between(recording.start(), end).toMillis() / 1000.0,
                recording.bytes(),
                recording.frames(),
                recording.drops(),
                WireNames.camel(recording.state()),
                recording.notice());
    }
}
