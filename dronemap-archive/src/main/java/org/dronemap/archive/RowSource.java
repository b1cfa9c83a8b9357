package org.dronemap.archive;

import java.io.IOException;
import java.time.LocalDate;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** A source of a day's telemetry rows for the archive: the same rows in the same order at each read. */
public interface RowSource {
    /** The values in the order of the columns, null: not known. Each moment of a drone once, by drone and time. */
    void of(LocalDate day, RowConsumer taker) throws IOException;

    /** Takes one row after the other. */
    interface RowConsumer {
        void row(List<@Nullable Object> values) throws IOException;
    }
}
