package org.dronemap.ws.plan;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.util.concurrent.CompletableFuture;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

/** REST handler that proposes a good order for the waypoints of one drone's mission. */
@RestController
@RequestMapping("/api/v1/tours")
@Tag(name = "Plans")
class TourController {
    private final TourService tours;
    private final CurrentPrincipal current;

    TourController(TourService tours, CurrentPrincipal current) {
        this.tours = tours;
        this.current = current;
    }

    @PostMapping
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.DRONE)
    @ResponseStatuses(refuses = 404)
    @Operation(
            operationId = "orderTour",
            summary = "Put the waypoints of one drone into a good order (planner)",
            description = "From where the drone is, round the zones that bind it; nothing is sent to it. Answered after"
                    + " the seconds of the search, at once where there are few waypoints. 409 while another one of"
                    + " yours is under way; 503 when too many wait already.")
    public CompletableFuture<TourView> order(@RequestBody TourRequest request) {
        return tours.order(current.principal(), request);
    }
}
