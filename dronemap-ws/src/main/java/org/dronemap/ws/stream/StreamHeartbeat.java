package org.dronemap.ws.stream;

import java.time.Clock;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.dronemap.ws.reading.JsonCodec;

/**
 * Message sent to every stream client once a second, by which a page notices within three seconds that its line is cut.
 * Owned by the pump.
 */
final class StreamHeartbeat {
    private static final long PERIOD_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final JsonCodec json;
    private final Clock clock;
    private long lastNanos;

    StreamHeartbeat(JsonCodec json, Clock clock, long nowNanos) {
        this.json = json;
        this.clock = clock;
        this.lastNanos = nowNanos;
    }

    /** The message, written once for all clients, when it is time for it. */
    Optional<String> due(long nowNanos) {
        if (nowNanos - lastNanos < PERIOD_NANOS) {
            return Optional.empty();
        }
        lastNanos = nowNanos;
        return Optional.of(json.write(new StreamMessage.Ping(clock.instant())));
    }
}
