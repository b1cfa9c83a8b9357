package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.junit.jupiter.api.Test;

class SetpointRefusalFilterTest {
    private static final CommandGate.Source EVE = new CommandGate.Source(new Principal("eve", Role.VIEWER), "outlet");

    private final SetpointRefusalFilter refusals = new SetpointRefusalFilter();

    @Test
    void areNewsAgainAfterTenSecondsAndForAnotherReasonAtOnce() {
        assertThat(refusals.isNews(EVE, "may only look", 0)).isTrue();
        assertThat(refusals.isNews(EVE, "may only look", SetpointRefusalFilter.AGAIN_NANOS - 1))
                .isFalse();
        assertThat(refusals.isNews(EVE, "no contact", SetpointRefusalFilter.AGAIN_NANOS - 1))
                .isTrue();
        assertThat(refusals.isNews(EVE, "may only look", SetpointRefusalFilter.AGAIN_NANOS))
                .isTrue();
    }

    @Test
    void areNoNewsWithOtherNumbers() {
        assertThat(refusals.isNews(EVE, "a zone after 11.5 m", 0)).isTrue();
        assertThat(refusals.isNews(EVE, "a zone after 7.2 m", 1)).isFalse();
    }

    @Test
    void areForgottenOldestFirstWhenThereAreMany() {
        for (int reason = 0; reason < 100; reason++) {
            assertThat(refusals.isNews(EVE, "reason " + "x".repeat(reason), reason))
                    .isTrue();
        }
        assertThat(refusals.isNews(EVE, "reason " + "x".repeat(99), 100)).isFalse();
        assertThat(refusals.isNews(EVE, "reason ", 100)).isTrue();
    }
}
