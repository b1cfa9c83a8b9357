package org.dronemap.core.audit;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import org.jspecify.annotations.Nullable;

/**
 * Content of one audit record: who called what on which drone, and how it ended; never holds a secret.
 *
 * @param at when it was asked for, of an ending: when it ended
 * @param by the user; null: nobody who could prove to be one
 * @param organisation the user's; null: the server's own matter
 * @param key the id of the access key that was shown; null: none
 * @param face the way in: page, rest, soap, stream, rule …
 * @param operation as the tables of who may do what call it
 * @param epoch of the control that it was given under; null: of none
 * @param command the id of the command that it is about; null: of none
 * @param parameters a summary for people
 * @param reason why it was refused or failed
 * @param latencyMillis from asking to this outcome; null: not known
 * @param ends the record of the call whose end this is; null: it is a call's record itself
 */
public record AuditEntry(
        Instant at,
        @Nullable String by,
        @Nullable String organisation,
        @Nullable String key,
        String face,
        String operation,
        @Nullable String drone,
        @Nullable Long epoch,
        @Nullable String command,
        String parameters,
        AuditOutcome outcome,
        @Nullable String reason,
        @Nullable Long latencyMillis,
        @Nullable Long ends) {
    /** Stands for the record of the command that an ending names, which only the keeper of the records can look up. */
    public static final long OF_ITS_COMMAND = 0;

    private static final int LONGEST_NAME = 100;
    private static final int LONGEST_PARAMETERS = 500;
    private static final int LONGEST_REASON = 300;

    public AuditEntry {
        at = at.truncatedTo(ChronoUnit.MICROS);
        by = AuditText.orNull(by, LONGEST_NAME);
        organisation = AuditText.orNull(organisation, LONGEST_NAME);
        key = AuditText.orNull(key, LONGEST_NAME);
        face = AuditText.of(face, LONGEST_NAME);
        operation = AuditText.of(operation, LONGEST_NAME);
        drone = AuditText.orNull(drone, LONGEST_NAME);
        command = AuditText.orNull(command, LONGEST_NAME);
        parameters = AuditText.of(parameters, LONGEST_PARAMETERS);
        reason = AuditText.orNull(reason, LONGEST_REASON);
    }

    /** Whose record only the keeper of the records can look up. */
    public boolean endsItsCommand() {
        return ends != null && ends == OF_ITS_COMMAND;
    }

    public AuditEntry ended(AuditOutcome how, @Nullable String why, @Nullable Long afterMillis) {
        return with(at, parameters, how, why, afterMillis, ends);
    }

    /** The end of the call that this is the record of. */
    public AuditEntry ending(Instant when, AuditOutcome how, @Nullable String why, @Nullable Long afterMillis) {
        return with(when, "", how, why, afterMillis, OF_ITS_COMMAND);
    }

    /** Null: the command has no record, so that this is all there is of it. */
    public AuditEntry endingOf(@Nullable Long record) {
        return with(at, parameters, outcome, reason, latencyMillis, record);
    }

    /** Of the same call. */
    private AuditEntry with(
            Instant when,
            String what,
            AuditOutcome how,
            @Nullable String why,
            @Nullable Long afterMillis,
            @Nullable Long record) {
        return new AuditEntry(
                when,
                by,
                organisation,
                key,
                face,
                operation,
                drone,
                epoch,
                command,
                what,
                how,
                why,
                afterMillis,
                record);
    }

    /** As it may be written down: what looks like a key is hidden, whatever it stands in. */
    AuditEntry withoutSecrets() {
        return new AuditEntry(
                at,
                by,
                organisation,
                key,
                face,
                AuditText.withoutSecrets(operation),
                AuditText.withoutSecretsOrNull(drone),
                epoch,
                command,
                AuditText.withoutSecrets(parameters),
                outcome,
                AuditText.withoutSecretsOrNull(reason),
                latencyMillis,
                ends);
    }

    AuditEntry asked(@Nullable String who, @Nullable String of, @Nullable String with) {
        return new AuditEntry(
                at,
                who,
                of,
                with,
                face,
                operation,
                drone,
                epoch,
                command,
                parameters,
                outcome,
                reason,
                latencyMillis,
                ends);
    }

    AuditEntry through(String way) {
        return new AuditEntry(
                at,
                by,
                organisation,
                key,
                way,
                operation,
                drone,
                epoch,
                command,
                parameters,
                outcome,
                reason,
                latencyMillis,
                ends);
    }

    AuditEntry doing(String what, String with) {
        return new AuditEntry(
                at,
                by,
                organisation,
                key,
                face,
                what,
                drone,
                epoch,
                command,
                with,
                outcome,
                reason,
                latencyMillis,
                ends);
    }

    AuditEntry to(@Nullable String which, @Nullable Long underEpoch) {
        return new AuditEntry(
                at,
                by,
                organisation,
                key,
                face,
                operation,
                which,
                underEpoch,
                command,
                parameters,
                outcome,
                reason,
                latencyMillis,
                ends);
    }
}
