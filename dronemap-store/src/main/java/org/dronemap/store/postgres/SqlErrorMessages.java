package org.dronemap.store.postgres;

import java.sql.SQLException;
import java.sql.SQLTransientConnectionException;
import java.util.Objects;
import org.dronemap.store.StoreException;

/** Explains database errors by their SQLSTATE in sentences for the server's operator, never repeating a password. */
final class SqlErrorMessages {
    private SqlErrorMessages() {}

    static StoreException exception(SQLException error) {
        return isOutOfReach(error) || isFull(error)
                ? StoreException.passing(of(error), error)
                : new StoreException(of(error), error);
    }

    static String of(SQLException error) {
        String state = state(error);
        String said = Objects.requireNonNullElse(error.getMessage(), state);
        if (isFull(error)) {
            return state.equals("53100")
                    ? "The disk of the database is full; free some space, nothing was lost: " + said
                    : "The database has run out of memory or another resource: " + said;
        }
        if (state.startsWith("28")) {
            return "The database does not accept the user or password that it was given: " + said;
        }
        if (state.equals("3D000")) {
            return "That database does not exist; create it first: " + said;
        }
        if (state.equals("42501")) {
            return "The database user lacks a right that is needed: " + said;
        }
        if (isOutOfReach(error)) {
            return "The database cannot be reached: " + said;
        }
        return "The database refused: " + said;
    }

    /** No room on the disk, or another resource of the server has run out (class 53). */
    static boolean isFull(SQLException error) {
        return state(error).startsWith("53") && !state(error).equals("53300");
    }

    /** True for errors that may pass by waiting: not reachable, starting, stopping, too many connections. */
    static boolean isOutOfReach(SQLException error) {
        String state = state(error);
        return (error instanceof SQLTransientConnectionException && state.isEmpty())
                || state.startsWith("08")
                || state.startsWith("57P")
                || state.equals("53300");
    }

    /** The SQLSTATE of the error or, for the pool's own errors, of what lies under it. */
    private static String state(SQLException error) {
        if (error.getSQLState() != null) {
            return error.getSQLState();
        }
        return error.getCause() instanceof SQLException cause ? state(cause) : "";
    }
}
