package org.dronemap.ws.log;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** The logs on board of a vehicle; {@code logs} is null until they were listed. */
@Schema(name = "LogsView")
public record OnboardLogsView(@Nullable List<LogView> logs) {
    /** {@code here}: the server has the whole of it. */
    @Schema(name = "LogView")
    public record LogView(int number, @Nullable Instant at, long sizeBytes, boolean here) {}
}
