package org.dronemap.core.audit;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A call on its way, and the records that it leaves. */
class AuditedCallTest {
    private final AuditedCall call = new AuditedCall(
            new AuditEntry(
                    Instant.EPOCH,
                    "ann",
                    "home",
                    null,
                    "rest",
                    "POST /api/v1/endpoints",
                    null,
                    null,
                    null,
                    "",
                    AuditOutcome.SUCCEEDED,
                    null,
                    null,
                    null),
            () -> 0);

    @Test
    void tellsOnceThatWhatWasWrittenAsDoneIsNot() {
        List<AuditEntry> written = new ArrayList<>();
        call.claim().ifPresent(written::add);
        call.written(7);
        call.turnedAway(AuditOutcome.REFUSED, "There is one already.");

        call.end(written::add);
        call.end(written::add);

        assertThat(written)
                .extracting(AuditEntry::outcome)
                .containsExactly(AuditOutcome.SUCCEEDED, AuditOutcome.REFUSED);
        assertThat(written.get(1).ends()).isEqualTo(7);
    }
}
