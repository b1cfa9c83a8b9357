package org.dronemap.store.postgres;

import java.sql.SQLException;
import org.jspecify.annotations.Nullable;

/**
 * Remembers whether the last required write to the database succeeded, as one that answers may have no space left. Any
 * thread.
 */
final class DatabaseWritability {
    private volatile @Nullable String trouble;

    void succeeded() {
        trouble = null;
    }

    /** What says nothing about the next change, such as a refused value, changes nothing. */
    void failed(SQLException error) {
        if (SqlErrorMessages.isFull(error)) {
            trouble = SqlErrorMessages.of(error);
        }
    }

    /** As a sentence; null: it can be written, as far as is known. */
    @Nullable
    String trouble() {
        return trouble;
    }
}
