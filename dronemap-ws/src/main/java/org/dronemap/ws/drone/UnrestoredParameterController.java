package org.dronemap.ws.drone;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.util.List;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

/** Lists parameters that could not be restored on drones that were removed. */
@RestController
@RequestMapping("/api/v1/left-behind")
@Tag(name = "Drones")
class UnrestoredParameterController {
    private final UnrestoredParameterService service;
    private final CurrentPrincipal current;

    /** All of them. */
    @Schema(name = "LeftBehind")
    public record UnrestoredDrones(List<UnrestoredParameterService.UnrestoredDroneView> drones) {}

    UnrestoredParameterController(UnrestoredParameterService service, CurrentPrincipal current) {
        this.service = service;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @Operation(
            operationId = "listLeftBehind",
            summary = "List removed drones with what their owners had set (administrator)",
            description = "What the cloud had changed on them was not put back before they were removed.")
    public UnrestoredDrones leftBehind() {
        return new UnrestoredDrones(service.leftBehind(current.principal()));
    }
}
