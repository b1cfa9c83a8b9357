package org.dronemap.ws.service;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** The logs on board of a vehicle; {@code logs} is null until they were listed. */
public record LogsView(@Nullable List<LogView> logs) {
    /** {@code here}: the server has the whole of it. */
    public record LogView(int number, @Nullable Instant at, long sizeBytes, boolean here) {}
}
