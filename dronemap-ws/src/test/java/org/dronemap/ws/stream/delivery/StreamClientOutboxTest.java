package org.dronemap.ws.stream.delivery;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.NullSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The outbox of a slow client: all that must arrive does, or it is closed. */
class StreamClientOutboxTest {
    private static final StreamMessageSubject DRONE = StreamMessageSubject.drone(new DroneId("drone-1"));

    private final StreamClientOutbox outbox = new StreamClientOutbox();

    @ParameterizedTest
    @NullSource
    @ValueSource(strings = "drone-1")
    void isOverflownWithOneMessageMoreThanItHoldsWhicheverItIs(@Nullable String about) {
        StreamMessageSubject drone = about == null ? null : StreamMessageSubject.drone(new DroneId(about));
        for (int count = 0; count < StreamClientOutbox.MOST_DISCRETE; count++) {
            outbox.add(drone, "{}");
        }
        assertThat(outbox.isOverflown()).isFalse();

        outbox.add(drone, "{}");
        assertThat(outbox.isOverflown()).isTrue();

        outbox.drain();
        outbox.add("{}");
        assertThat(outbox.isOverflown()).as("what was lost stays lost").isTrue();
    }

    @Test
    void stateOfADroneIsReplacedAndTakesNoRoomFromWhatMustArrive() {
        for (int count = 0; count <= StreamClientOutbox.MOST_DISCRETE; count++) {
            outbox.offer(DRONE, "picture " + count);
        }
        outbox.add(DRONE, "outcome");

        assertThat(outbox.isOverflown()).isFalse();
        assertThat(outbox.replacedCount()).isEqualTo(StreamClientOutbox.MOST_DISCRETE);
        assertThat(outbox.drain()).isEqualTo(List.of("outcome", "picture " + StreamClientOutbox.MOST_DISCRETE));
    }

    @Test
    void whoIsSlowToReadFindsTheNewestSignOfLifeAloneAndLast() {
        for (int count = 0; count <= StreamClientOutbox.MOST_DISCRETE; count++) {
            outbox.beat("beat " + count);
        }
        outbox.offer(DRONE, "picture");
        outbox.add("outcome");

        assertThat(outbox.isOverflown()).isFalse();
        assertThat(outbox.isEmpty()).isFalse();
        assertThat(outbox.drain()).containsExactly("outcome", "picture", "beat " + StreamClientOutbox.MOST_DISCRETE);
        assertThat(outbox.isEmpty()).isTrue();
        assertThat(outbox.drain()).isEmpty();
    }
}
