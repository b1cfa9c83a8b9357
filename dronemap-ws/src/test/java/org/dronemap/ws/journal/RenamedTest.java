package org.dronemap.ws.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** The same things before and after all of them were renamed in the code. */
class RenamedTest {
    private static final Before BEFORE =
            new Before.Moved(Instant.EPOCH, new Before.Place(1.5, -2), List.of(Before.State.UP, Before.State.DOWN));
    private static final After AFTER =
            new After.Shifted(Instant.EPOCH, new After.Spot(1.5, -2), List.of(After.Phase.RISEN, After.Phase.LANDED));

    private final JsonOperationCodec<Before, Before> before =
            new JsonOperationCodec<>(Before.class, Before.class, List.of()) {};
    private final JsonOperationCodec<After, After> after =
            new JsonOperationCodec<>(After.class, After.class, List.of()) {};

    private sealed interface Before {
        @Stored(as = "Moved", names = "at place states")
        record Moved(Instant at, Place place, List<State> states) implements Before {}

        @Stored(names = "north east")
        record Place(double north, double east) {}

        @Stored(names = "UP DOWN")
        enum State {
            UP,
            DOWN
        }
    }

    private sealed interface After {
        @Stored(as = "Moved", names = "at place states")
        record Shifted(Instant when, Spot where, List<Phase> phases) implements After {}

        @Stored(names = "north east")
        record Spot(double northMeters, double eastMeters) {}

        @Stored(names = "UP DOWN")
        enum Phase {
            RISEN,
            LANDED
        }
    }

    @Stored(names = "at")
    private record Sooner(Instant at) {}

    @Stored(names = "at why told", later = "why told")
    private record Later(Instant at, @Nullable String why, List<String> told) {}

    private record Nameless(Instant at) {}

    private sealed interface Kinds {
        @Stored(names = "at")
        record OfNoName(Instant at) implements Kinds {}
    }

    @Test
    void writesTheSameTextAfterARename() {
        assertThat(after.state(AFTER))
                .isEqualTo(before.state(BEFORE))
                .isEqualTo("{\"type\":\"Moved\",\"at\":\"1970-01-01T00:00:00Z\","
                        + "\"place\":{\"north\":1.5,\"east\":-2.0},\"states\":[\"UP\",\"DOWN\"]}");
    }

    @Test
    void readsWhatWasWrittenBeforeARename() {
        assertThat(after.state(before.state(BEFORE))).isEqualTo(AFTER);
    }

    @Test
    void writesWhatLacksALaterComponentAsItWas() {
        JsonOperationCodec<Later, Later> later = new JsonOperationCodec<>(Later.class, Later.class, List.of()) {};
        JsonOperationCodec<Sooner, Sooner> sooner = new JsonOperationCodec<>(Sooner.class, Sooner.class, List.of()) {};
        Later nothing = new Later(Instant.EPOCH, null, List.of());

        String text = sooner.state(new Sooner(Instant.EPOCH));

        assertThat(later.state(text)).isEqualTo(nothing);
        assertThat(later.state(nothing)).isEqualTo(text);
        assertThat(later.state(new Later(Instant.EPOCH, "why", List.of("x"))))
                .isEqualTo("{\"at\":\"1970-01-01T00:00:00Z\",\"why\":\"why\",\"told\":[\"x\"]}");
    }

    @Test
    void doesNotStartWithWhatHasNoStoredName() {
        assertThatThrownBy(() -> new JsonOperationCodec<>(Before.class, Nameless.class, List.of()) {})
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("Nameless is stored and needs @Stored");
        assertThatThrownBy(() -> new JsonOperationCodec<>(Before.class, Kinds.class, List.of()) {})
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("OfNoName needs @Stored(as");
    }
}
