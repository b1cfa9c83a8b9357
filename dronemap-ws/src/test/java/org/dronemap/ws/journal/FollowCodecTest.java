package org.dronemap.ws.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import org.dronemap.cognitive.operation.follow.FollowInput;
import org.junit.jupiter.api.Test;

class FollowCodecTest {
    private static final FollowInput.Modes HOMEWARD = new FollowInput.Modes("GUIDED", true);

    private final FollowCodec codec = new FollowCodec();

    @Test
    void readsWhatWasSeenBeforeLooksToldWhatModesAreFor() {
        FollowInput.Look look =
                new FollowInput.Look(null, 0, true, true, false, true, "SMART_RTL", 90, 300.0, null, HOMEWARD);
        FollowInput seen = new FollowInput.Looked(Instant.EPOCH, look, null, null, null, List.of());
        String told = ",\"modes\":{\"orders\":\"GUIDED\",\"home\":true}";

        String text = codec.input(seen);

        assertThat(text).contains(told);
        assertThat(codec.input(text)).isEqualTo(seen);
        assertThat(codec.input(text.replace(told, ""))).isEqualTo(seen);
    }
}
