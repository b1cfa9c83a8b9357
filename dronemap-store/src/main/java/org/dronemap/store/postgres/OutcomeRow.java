package org.dronemap.store.postgres;

import java.sql.SQLException;
import org.dronemap.core.command.Outcome;
import org.jspecify.annotations.Nullable;

/** An outcome as its three columns. */
record OutcomeRow(
        @Nullable String result,
        @Nullable String by,
        @Nullable String reason) {
    static OutcomeRow of(@Nullable Outcome outcome) {
        if (outcome == null) {
            return new OutcomeRow(null, null, null);
        } else if (outcome instanceof Outcome.Succeeded) {
            return new OutcomeRow("SUCCEEDED", null, null);
        } else if (outcome instanceof Outcome.Refused refused) {
            return new OutcomeRow("REFUSED", refused.by(), refused.reason());
        } else if (outcome instanceof Outcome.Failed failed) {
            return new OutcomeRow("FAILED", null, failed.reason());
        } else if (outcome instanceof Outcome.TimedOut timedOut) {
            return new OutcomeRow("TIMED_OUT", null, timedOut.reason());
        } else if (outcome instanceof Outcome.Superseded superseded) {
            return new OutcomeRow("SUPERSEDED", null, superseded.reason());
        } else if (outcome instanceof Outcome.Unknown unknown) {
            return new OutcomeRow("UNKNOWN", null, unknown.reason());
        }
        throw new IllegalArgumentException("no form for outcome " + outcome);
    }

    static @Nullable Outcome read(Row row) throws SQLException {
        String result = row.textOrNull("outcome");
        if (result == null) {
            return null;
        }
        return switch (result) {
            case "SUCCEEDED" -> new Outcome.Succeeded();
            case "REFUSED" -> new Outcome.Refused(row.text("outcome_by"), row.text("outcome_reason"));
            case "FAILED" -> new Outcome.Failed(row.text("outcome_reason"));
            case "TIMED_OUT" -> new Outcome.TimedOut(row.text("outcome_reason"));
            case "SUPERSEDED" -> new Outcome.Superseded(row.text("outcome_reason"));
            case "UNKNOWN" -> new Outcome.Unknown(row.text("outcome_reason"));
            default -> throw new SQLException("unknown outcome " + result);
        };
    }
}
