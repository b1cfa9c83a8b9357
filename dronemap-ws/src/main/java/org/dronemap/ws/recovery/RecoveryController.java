package org.dronemap.ws.recovery;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.util.List;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers by which a user brings several drones home, or down, together. */
@RestController
@RequestMapping("/api/v1/recoveries")
@Tag(
        name = "Recoveries",
        description =
                "Return all and land all: several drones come home, each at a height of its own and in its turn, or land"
                        + " where they are, as one operation with an outcome for each. A preview shows it before it begins.")
class RecoveryController {
    private final RecoveryService recoveries;
    private final CurrentPrincipal current;

    /** Recoveries, the newest first. */
    @Schema(name = "RecoveryList")
    public record RecoveryList(List<RecoveryView> recoveries) {}

    RecoveryController(RecoveryService recoveries, CurrentPrincipal current) {
        this.recoveries = recoveries;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @Operation(
            operationId = "listRecoveries",
            summary = "List recoveries",
            description =
                    "Yours, and those of your organisation whose drones you all see: under way, and the newest that are over.")
    public RecoveryList all() {
        return new RecoveryList(recoveries.all(current.principal()));
    }

    @GetMapping("/{id}")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @Operation(operationId = "getRecovery", summary = "Look at one recovery")
    public RecoveryView one(@PathVariable String id) {
        return recoveries.one(current.principal(), id);
    }

    @PostMapping("/preview")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "previewRecovery",
            summary = "Preview a recovery (operator)",
            description =
                    "What the same request would do if it were begun now: which drones come, at which height, in which"
                            + " order, and where each comes down; and which are left alone, with the reason. Nothing is"
                            + " commanded. 409 when they do not fit, with the number that does.")
    public RecoveryPreview preview(@RequestBody RecoveryRequest request) {
        return recoveries.preview(current.principal(), request);
    }

    @PostMapping
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @ResponseStatuses(201)
    @Operation(
            operationId = "beginRecovery",
            summary = "Bring drones home, or down, together (operator)",
            description =
                    "All stop where they are. Then each that returns climbs or descends to a height of its own, which is set"
                            + " as its return height too, and flies home in its turn; pads near each other are used one after"
                            + " the other. Each that lands does so where it is, one after the other where they are near. The"
                            + " return heights are put back on the ground. 409 when they do not fit between the lowest height"
                            + " and the ceiling, with the number that does, or when two would come down on one spot.")
    public ResponseEntity<RecoveryView> begin(@RequestBody RecoveryRequest request) {
        RecoveryView begun = recoveries.begin(current.principal(), request);
        return ResponseEntity.created(URI.create("/api/v1/recoveries/" + begun.id()))
                .body(begun);
    }

    @PostMapping("/{id}/cancel")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "cancelRecovery",
            summary = "Call a recovery off (operator)",
            description =
                    "Its drones hold where they are, and whoever asked for it gets control of them; those that are descending"
                            + " already come down. Who gives no signs of life then has them come home, as always. 409 when it"
                            + " was called off already, or is over.")
    public RecoveryView cancel(@PathVariable String id) {
        return recoveries.cancel(current.principal(), id);
    }
}
