package org.dronemap.ws.dispatch;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.util.List;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.access.SoapName;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers by which a user sends a drone of the pool to a place, sees how it comes, and calls it off. */
@RestController
@RequestMapping("/api/v1/dispatches")
@Tag(
        name = "Dispatches",
        description =
                "Send a drone here: the best free drone of the pool is chosen, takes off, flies to a place and holds there, and"
                        + " whoever asked gets control of it. When it cannot come, another one does.")
class DispatchController {
    private final DispatchService dispatches;
    private final CurrentPrincipal current;

    /** Dispatches, the newest first. */
    @Schema(name = "DispatchList")
    public record DispatchList(List<DispatchView> dispatches) {}

    DispatchController(DispatchService dispatches, CurrentPrincipal current) {
        this.dispatches = dispatches;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @SoapName("getDispatchesList")
    @Operation(
            operationId = "listDispatches",
            summary = "List drones that were sent",
            description =
                    "Yours, and those of your organisation whose drones you all see: under way, and the newest that are over.")
    public DispatchList all() {
        return new DispatchList(dispatches.all(current.principal()));
    }

    @GetMapping("/{id}")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @Operation(operationId = "getDispatch", summary = "Look at one drone that was sent")
    public DispatchView one(@PathVariable String id) {
        return dispatches.one(current.principal(), id);
    }

    @PostMapping
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @ResponseStatuses(201)
    @Operation(
            operationId = "sendDrone",
            summary = "Send a drone here (operator)",
            description =
                    "Of the drones of the pool that you may command, the nearest that can come is chosen: it is free, zones let it"
                            + " go there and back, its battery lasts with a reserve, its link is good, and it can hover. It starts"
                            + " at once. When it is there, you have control of it, as if you had taken it: give signs of life from"
                            + " then on, within 20 s, or it holds and flies home. 409 with why each cannot, when none can.")
    public ResponseEntity<DispatchView> send(@RequestBody DispatchRequest request) {
        DispatchView sent = dispatches.send(current.principal(), request);
        return ResponseEntity.created(URI.create("/api/v1/dispatches/" + sent.id()))
                .body(sent);
    }

    @PostMapping("/{id}/cancel")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "cancelDispatch",
            summary = "Call a drone off that was sent (operator)",
            description =
                    "It flies home, also when it is there and you have control of it. 409 when it was called off already, or is"
                            + " over.")
    public DispatchView cancel(@PathVariable String id) {
        return dispatches.cancel(current.principal(), id);
    }
}
