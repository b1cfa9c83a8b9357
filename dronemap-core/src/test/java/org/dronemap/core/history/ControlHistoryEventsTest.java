package org.dronemap.core.history;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.LeaseHolder;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** The history says who did what to whom: the other one is never the one who acted. */
class ControlHistoryEventsTest {
    private static final LeaseHolder MIA = new LeaseHolder.Person("mia");
    private static final LeaseHolder PILOT = new LeaseHolder.Pilot();

    private static String told(ControlChange.Kind kind, LeaseHolder by, @Nullable LeaseHolder other, String reason) {
        ControlChange change = new ControlChange(kind, by, other, reason);
        return ControlHistoryEvents.of(new DroneId("d1"), Instant.EPOCH, change).text();
    }

    @Test
    void saysThatAPilotHasControlAndWhoHasItNoLonger() {
        assertThat(told(ControlChange.Kind.PILOT_ACTED, PILOT, MIA, "LOITER"))
                .isEqualTo("A pilot at the vehicle or another ground station changed the mode to LOITER and has"
                        + " control now, not mia.");
    }

    @Test
    void saysFromWhomAndToWhom() {
        assertThat(told(ControlChange.Kind.TAKEN_OVER, PILOT, MIA, "late")).endsWith(" took control over from mia.");
        assertThat(told(ControlChange.Kind.HANDED_OVER, PILOT, MIA, "late")).endsWith(" handed control over to mia.");
        assertThat(told(ControlChange.Kind.REFUSED, PILOT, MIA, "late"))
                .endsWith(" kept control, which mia had asked for.");
        assertThat(told(ControlChange.Kind.REQUESTED, PILOT, MIA, "late")).endsWith(" asked mia for control.");
    }

    @Test
    void isOneSentenceWithoutANameInParentheses() {
        for (ControlChange.Kind kind : ControlChange.Kind.values()) {
            assertThat(told(kind, MIA, PILOT, "because")).doesNotContain("(").endsWith(".");
            assertThat(told(kind, MIA, null, "because")).doesNotContain("null").endsWith(".");
        }
    }
}
