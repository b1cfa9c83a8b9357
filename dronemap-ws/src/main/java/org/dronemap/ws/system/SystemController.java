package org.dronemap.ws.system;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.history.HistoryStatusService;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers for the health and the settings of the server itself. */
@RestController
@RequestMapping("/api/v1")
@Tag(name = "Server", description = "Health and settings.")
class SystemController {
    private final SystemService system;
    private final HistoryStatusService history;
    private final CurrentPrincipal current;

    SystemController(SystemService system, HistoryStatusService history, CurrentPrincipal current) {
        this.system = system;
        this.history = history;
        this.current = current;
    }

    @GetMapping("/health")
    @Access(from = AccessLevel.ANYBODY, about = ResourceScope.NONE)
    @ResponseStatuses(never = 503)
    @Operation(
            operationId = "getHealth",
            summary = "Is the server well? (no sign-in)",
            description = "ready counts the drones that can be armed.")
    public HealthView health() {
        return system.health();
    }

    @GetMapping("/health/parts")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @Operation(
            operationId = "getHealthParts",
            summary = "How each part of the server is, and why it ended last (administrator)")
    public HealthView.Details parts() {
        return system.details(current.principal());
    }

    @GetMapping("/history")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @Operation(operationId = "getHistory", summary = "Is all that drones do written down? (administrator)")
    public HistoryStatusService.HistoryView history() {
        return history.status(current.principal());
    }

    @GetMapping("/settings")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.NONE)
    @Operation(operationId = "getSettings", summary = "What a client has to know of the server")
    public SystemService.SettingsView settings() {
        current.requireSignedIn();
        return system.settings();
    }
}
