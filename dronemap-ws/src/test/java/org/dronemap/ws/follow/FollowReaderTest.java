package org.dronemap.ws.follow;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.operation.TargetReport;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class FollowReaderTest {
    private static final Instant SENT = Instant.parse("2026-01-31T12:00:00Z");

    private static FollowRequest.PositionRequest position(Instant at, @Nullable Double speed) {
        return new FollowRequest.PositionRequest(null, at, 47.0, 8.0, 5.0, speed, null);
    }

    private static List<TargetReport> read(FollowRequest.PositionRequest... positions) {
        return FollowReader.sightings(new FollowRequest.PositionsRequest(SENT, null, List.of(positions)), SENT);
    }

    @Test
    void takesAReceiverThatIsAheadOfItsPhoneForSimultaneous() {
        assertThat(read(position(SENT.plus(Duration.ofSeconds(60)), null)))
                .extracting(TargetReport::observedAt, TargetReport::number)
                .as("what comes next has a higher number")
                .containsExactly(tuple(SENT, SENT.toEpochMilli()));
    }

    /** Taken as the newest for years it would make all that follows seem known. */
    @Test
    void refusesAPositionThatIsLaterThanItsMessage() {
        assertThatThrownBy(() -> read(position(SENT.plus(Duration.ofSeconds(61)), null)))
                .hasMessage("\"positions[0].at\" must be at most 60 s after \"sent\", not 2026-01-31T12:01:01Z.");
    }

    @Test
    void refusesASpeedThatIsNoneAlsoWithoutACourse() {
        assertThatThrownBy(() -> read(position(SENT, 5_000.0)))
                .hasMessageContaining("positions[0].speed")
                .hasMessageContaining("0 to 100 m/s");
    }
}
