package org.dronemap.store.postgres;

import java.sql.SQLException;
import org.jspecify.annotations.Nullable;

/** Whether the last change that had to be written could be: a database that answers questions may have no room left. Any thread. */
final class Writability {
    private volatile @Nullable String trouble;

    void wrote() {
        trouble = null;
    }

    /** What says nothing about the next change, such as a refused value, changes nothing. */
    void failed(SQLException error) {
        if (SqlSentence.isFull(error)) {
            trouble = SqlSentence.of(error);
        }
    }

    /** As a sentence; null: it can be written, as far as is known. */
    @Nullable
    String trouble() {
        return trouble;
    }
}
