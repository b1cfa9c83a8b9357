package org.dronemap.ws.stream;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.concurrent.TimeUnit;
import org.dronemap.ws.reading.JsonCodec;
import org.junit.jupiter.api.Test;

/** The sign of life by which pages know that their line stands. */
class StreamHeartbeatTest {
    private static final Clock NOON = Clock.fixed(Instant.parse("2026-01-01T12:00:00Z"), ZoneOffset.UTC);

    private final StreamHeartbeat beat = new StreamHeartbeat(new JsonCodec(), NOON, 0);

    @Test
    void isDueOnceASecondSoThatACutLineCanBeToldWithinThree() {
        assertThat(beat.due(TimeUnit.MILLISECONDS.toNanos(999))).isEmpty();
        assertThat(beat.due(TimeUnit.MILLISECONDS.toNanos(1_000)))
                .contains("{\"type\":\"ping\",\"at\":\"2026-01-01T12:00:00Z\"}");
        assertThat(beat.due(TimeUnit.MILLISECONDS.toNanos(1_999))).isEmpty();
        assertThat(beat.due(TimeUnit.MILLISECONDS.toNanos(2_040))).isPresent();
    }
}
