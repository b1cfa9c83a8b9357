package org.dronemap.store.postgres;

import java.sql.SQLException;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.jspecify.annotations.Nullable;

/** The outcome of a command as the four columns that PostgreSQL keeps of it. */
record OutcomeColumns(
        @Nullable String result,
        @Nullable String by,
        @Nullable String reason,
        @Nullable OutcomeCode code) {
    static OutcomeColumns of(@Nullable Outcome outcome) {
        if (outcome == null) {
            return new OutcomeColumns(null, null, null, null);
        }
        OutcomeCode code = outcome instanceof Outcome.Refused refused ? refused.cause() : null;
        return new OutcomeColumns(result(outcome), outcome.by(), outcome.reason(), code);
    }

    private static String result(Outcome outcome) {
        return switch (outcome.kind()) {
            case SUCCEEDED -> "SUCCEEDED";
            case REFUSED -> "REFUSED";
            case FAILED -> "FAILED";
            case TIMED_OUT -> "TIMED_OUT";
            case SUPERSEDED -> "SUPERSEDED";
            case UNKNOWN -> "UNKNOWN";
        };
    }

    static @Nullable Outcome read(ResultRow row) throws SQLException {
        String result = row.textOrNull("outcome");
        if (result == null) {
            return null;
        }
        return switch (result) {
            case "SUCCEEDED" -> new Outcome.Succeeded();
            case "REFUSED" ->
                new Outcome.Refused(
                        row.text("outcome_by"),
                        row.text("outcome_reason"),
                        row.nameOrNull("outcome_code", OutcomeCode.class));
            case "FAILED" -> new Outcome.Failed(row.text("outcome_reason"));
            case "TIMED_OUT" -> new Outcome.TimedOut(row.text("outcome_reason"));
            case "SUPERSEDED" -> new Outcome.Superseded(row.text("outcome_reason"));
            case "UNKNOWN" -> new Outcome.Unknown(row.text("outcome_reason"));
            default -> throw new SQLException("unknown outcome " + result);
        };
    }
}
