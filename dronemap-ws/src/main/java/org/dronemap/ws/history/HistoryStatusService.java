package org.dronemap.ws.history;

import io.swagger.v3.oas.annotations.media.Schema;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.history.HistoryHealth;
import org.dronemap.core.history.HistoryRecorder;
import org.dronemap.ws.access.RoleChecks;
import org.jspecify.annotations.Nullable;

/** Reports to administrators how completely the history of drones is being stored. Any thread. */
public final class HistoryStatusService {
    private final HistoryRecorder history;

    /** Status of the telemetry store: its server and trouble, and counts of records written, dropped and waiting. */
    @Schema(name = "HistoryView")
    public record HistoryView(
            @Schema(description = "What telemetry is kept in, with its version; null while it does not answer")
            @Nullable
            String server,

            boolean up,

            @Schema(description = "What is wrong, a sentence; null: nothing") @Nullable
            String trouble,

            @Schema(description = "States and events since the start")
            long written,

            @Schema(description = "States and events since the start that are missing for ever")
            long dropped,

            @Schema(description = "States and events that are not written yet")
            int waiting) {}

    public HistoryStatusService(HistoryRecorder history) {
        this.history = history;
    }

    public HistoryView status(Principal principal) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        HistoryHealth health = history.health();
        String server = null;
        String trouble = health.trouble();
        try {
            server = history.telemetry().server();
        } catch (RuntimeException away) {
            trouble = trouble == null ? away.getMessage() : trouble;
        }
        return new HistoryView(server, trouble == null, trouble, health.written(), health.dropped(), health.waiting());
    }
}
