package org.dronemap.ws.audit;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditedCallRecord;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** An audit record as clients see it; null: not known, or none. */
@Schema(name = "AuditView")
public record AuditView(
        long sequence,
        Instant at,
        @Nullable String by,

        @Schema(description = "Id of the access key that was shown") @Nullable
        String accessKey,

        String face,
        String operation,
        @Nullable String drone,
        @Nullable Long epoch,
        @Nullable String command,
        String parameters,

        @EnumValues(AuditOutcome.class) String outcome,

        @Nullable String reason,
        @Nullable Long latencyMillis,

        @Schema(description = "Of the record, over all before it as well")
        String hash) {
    static AuditView of(AuditedCallRecord line) {
        AuditEntry entry = line.record().entry();
        return new AuditView(
                line.record().sequence(),
                entry.at().truncatedTo(ChronoUnit.MILLIS),
                entry.by(),
                entry.key(),
                entry.face(),
                entry.operation(),
                entry.drone(),
                entry.epoch(),
                entry.command(),
                entry.parameters(),
                WireNames.camel(line.outcome()),
                line.reason(),
                line.latencyMillis(),
                line.record().hash());
    }
}
