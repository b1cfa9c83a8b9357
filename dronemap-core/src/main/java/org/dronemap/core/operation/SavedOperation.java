package org.dronemap.core.operation;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;
import org.jspecify.annotations.Nullable;

/**
 * An operation as stored over restarts: kind, owner, state as text and commands under way.
 *
 * @param kind names who knows what its state means
 * @param owner the name of the user whom it is conducted for, as it was then
 * @param account of that user
 * @param endedAt null while it is under way
 * @param last the number of the newest entry of its journal
 * @param given commands whose ends it has not been told yet
 * @param state a text of its kind's own
 */
public record SavedOperation(
        OperationId id,
        String kind,
        String owner,
        String account,
        OrganisationId organisation,
        String name,
        Instant beganAt,
        @Nullable Instant endedAt,
        long last,
        List<Given> given,
        String state) {
    public SavedOperation {
        given = List.copyOf(given);
    }

    /** A command of it. */
    public record Given(DroneId drone, CommandId command) {}

    /** As the next entry of its journal leaves it. */
    public SavedOperation next(String newer, List<Given> open, @Nullable Instant end) {
        return new SavedOperation(id, kind, owner, account, organisation, name, beganAt, end, last + 1, open, newer);
    }

    /** The same, told how the others ended. */
    public SavedOperation with(List<Given> open) {
        return new SavedOperation(id, kind, owner, account, organisation, name, beganAt, endedAt, last, open, state);
    }

    /** A new one. */
    public static SavedOperation begun(OperationId id, String kind, Owner owner, String name, Instant at) {
        return new SavedOperation(
                id, kind, owner.user(), owner.account(), owner.organisation(), name, at, null, 0, List.of(), "");
    }

    /** Owner of an operation: the user whom it is conducted for, with account and organisation. */
    public record Owner(String user, String account, OrganisationId organisation) {}

    /** With the state that it begins with. */
    public SavedOperation beginning(String first) {
        return new SavedOperation(id, kind, owner, account, organisation, name, beganAt, null, 0, List.of(), first);
    }
}
