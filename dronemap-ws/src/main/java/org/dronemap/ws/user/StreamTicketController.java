package org.dronemap.ws.user;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.dronemap.ws.security.StreamTickets;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

/** REST handler that issues a ticket with which a signed-in page opens the WebSocket stream. */
@RestController
@RequestMapping("/api/v1/stream-tickets")
@Tag(name = "Stream", description = "States and commands as they change, over a WebSocket on the stream port.")
class StreamTicketController {
    private final StreamTickets tickets;
    private final CurrentPrincipal current;

    /** Goes into the stream's address as {@code ?ticket=…}. */
    @Schema(name = "StreamTicket")
    public record Ticket(String ticket) {}

    StreamTicketController(StreamTickets tickets, CurrentPrincipal current) {
        this.tickets = tickets;
        this.current = current;
    }

    @PostMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.OWN)
    @ResponseStatuses(never = 409)
    @Operation(
            operationId = "makeStreamTicket",
            summary = "Get a ticket for the stream",
            description = "Good for one connection within 30 s.")
    public Ticket ticket() {
        return new Ticket(tickets.issue(current.signedIn()));
    }
}
