package org.dronemap.ws.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import org.dronemap.cognitive.operation.follow.FollowInput;
import org.junit.jupiter.api.Test;

class FollowJournalCodecTest {
    private final FollowJournalCodec codec = new FollowJournalCodec();

    private static FollowInput seen(FollowInput.ModeMeaning modes) {
        FollowInput.Observation look =
                new FollowInput.Observation(null, 0, true, true, false, true, "SMART_RTL", 90, 300.0, null, modes);
        return new FollowInput.Observed(Instant.EPOCH, look, null, null, null, List.of());
    }

    /** So that an entry of then is written again as it was. */
    @Test
    void writesModesOnlyWhereTheyCannotBeToldWithoutThem() {
        FollowInput usual = seen(new FollowInput.ModeMeaning("GUIDED", true));

        String text = codec.input(usual);

        assertThat(text).doesNotContain("modes");
        assertThat(codec.input(text)).isEqualTo(usual);
    }

    @Test
    void writesOtherModesAsTheyAre() {
        FollowInput other = seen(new FollowInput.ModeMeaning("OFFBOARD", true));
        FollowInput none = seen(new FollowInput.ModeMeaning(null, false));

        assertThat(codec.input(other)).contains(",\"modes\":{\"orders\":\"OFFBOARD\",\"home\":true}");
        assertThat(codec.input(codec.input(other))).isEqualTo(other);
        assertThat(codec.input(codec.input(none))).isEqualTo(none);
    }
}
