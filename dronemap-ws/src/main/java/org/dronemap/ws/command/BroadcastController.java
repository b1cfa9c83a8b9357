package org.dronemap.ws.command;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.jspecify.annotations.Nullable;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

/** REST handler that gives one command to several drones. */
@RestController
@RequestMapping("/api/v1/commands")
@Tag(name = "Commands")
class BroadcastController {
    private final BroadcastService broadcasts;
    private final CurrentPrincipal current;

    BroadcastController(BroadcastService broadcasts, CurrentPrincipal current) {
        this.broadcasts = broadcasts;
        this.current = current;
    }

    @PostMapping
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE, costs = RequestCost.NOTHING)
    @ResponseStatuses({200, 202})
    @Operation(
            operationId = "broadcastCommand",
            summary = "Give one command to several drones or all (operator)",
            description = "One result for each drone, in the order asked: its command, refused, under way or ended."
                    + " 200 when none is under way any more, else 202.")
    public CompletableFuture<ResponseEntity<BroadcastView>> submit(
            @Parameter(description = "Seconds to wait for the outcomes, 0 to 60")
                    @RequestParam(required = false)
                    @Nullable
                    Double wait,
            @RequestBody BroadcastRequest request) {
        Duration longest = CommandResponse.wait(wait);
        BroadcastView broadcast = broadcasts.submit(current.principal(), current.face(), request);
        return broadcasts.awaitEnd(broadcast, longest).thenApply(BroadcastController::answer);
    }

    private static ResponseEntity<BroadcastView> answer(BroadcastView broadcast) {
        return ResponseEntity.status(broadcast.isEnded() ? HttpStatus.OK : HttpStatus.ACCEPTED)
                .body(broadcast);
    }
}
