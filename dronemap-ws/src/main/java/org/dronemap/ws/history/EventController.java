package org.dronemap.ws.history;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.util.concurrent.CompletableFuture;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.security.CurrentPrincipal;
import org.jspecify.annotations.Nullable;
import org.springdoc.core.annotations.ParameterObject;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.ModelAttribute;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

/** REST handler for programs that follow what happens to all drones. */
@RestController
@RequestMapping("/api/v1/events")
@Tag(name = "Events", description = "What happens to all drones, for programs that miss nothing of it.")
class EventController {
    private final EventFollowService events;
    private final CurrentPrincipal current;

    EventController(EventFollowService events, CurrentPrincipal current) {
        this.events = events;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(
            operationId = "followEvents",
            summary = "Follow what happens to drones",
            description = "In the order in which it was stored; go on with after = next. With wait, the answer comes as"
                    + " soon as there is an event, or without one after that time. Where events are missing, gaps says"
                    + " so.")
    public CompletableFuture<FollowedEventsView> follow(
            @ParameterObject @ModelAttribute EventFollowRequest request,
            @Parameter(description = "Seconds to wait for an event, 0 to 60; 0 unless said otherwise")
                    @RequestParam(required = false)
                    @Nullable
                    Double wait) {
        return events.follow(current.signedIn(), request, wait);
    }
}
