package org.dronemap.ws.link;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.link.EndpointStore;
import org.dronemap.core.link.SavedEndpoint;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.problem.DroneProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/**
 * Lists, adds and removes the endpoints that vehicles connect to, and shows their traffic, for administrators. Any
 * thread.
 */
final class EndpointService {
    private static final String URL_FORM = "the URL of an endpoint, such as udpserver://0.0.0.0:14550";
    private static final int ID_LETTERS = 10;

    private final VehicleEndpointGateway links;
    private final EndpointStore store;
    private final Clock clock;

    /** A new endpoint as an administrator writes it. */
    @Schema(name = "EndpointRequest")
    record EndpointRequest(@Nullable String url) {}

    EndpointService(VehicleEndpointGateway links, EndpointStore store, Clock clock) {
        this.links = links;
        this.store = store;
        this.clock = clock;
    }

    List<EndpointView> endpoints(Principal principal) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        Map<String, SavedEndpoint> saved =
                store.links().stream().collect(Collectors.toMap(SavedEndpoint::id, Function.identity()));
        return links.all().stream()
                .map(status -> view(status, saved.get(status.id())))
                .toList();
    }

    EndpointView endpoint(Principal principal, String id) {
        return endpoints(principal).stream()
                .filter(endpoint -> endpoint.id().equals(id))
                .findFirst()
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.ENDPOINT, id));
    }

    /** Kept from now on, also over restarts; listed as failed, with the reason, while it cannot open. */
    EndpointView add(Principal principal, EndpointRequest request) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        String url = checked(request.url());
        String id = "e" + UUID.randomUUID().toString().replace("-", "").substring(0, ID_LETTERS);
        if (!store.addLink(new SavedEndpoint(id, url, principal.name(), clock.instant()))) {
            throw Rejection.of(DroneProblem.ENDPOINT_KNOWN, "There is an endpoint " + url + " already.");
        }
        try {
            links.keep(id, url);
        } catch (IllegalStateException noRoom) {
            store.deleteLink(id);
            throw Rejection.of(
                    ServerProblem.LIMIT_REACHED,
                    String.valueOf(noRoom.getMessage()),
                    ProblemParameter.WHAT.is("endpoints"));
        }
        return endpoint(principal, id);
    }

    private String checked(@Nullable String url) {
        if (url == null) {
            throw InvalidInput.missing("url", URL_FORM);
        }
        try {
            return links.checked(url);
        } catch (IllegalArgumentException e) {
            throw new InvalidInput(ValueProblem.VALUE_MALFORMED, "url", URL_FORM, String.valueOf(e.getMessage()));
        }
    }

    void remove(Principal principal, String id) {
        EndpointView endpoint = endpoint(principal, id);
        if (!store.deleteLink(id)) {
            throw Rejection.of(
                    DroneProblem.ENDPOINT_OF_SETTING,
                    endpoint.url() + " is set by DRONEMAP_ENDPOINTS or DRONEMAP_ROBOTS; change the setting.");
        }
        links.remove(id);
    }

    /** What went over the link of each vehicle. */
    List<LinkTrafficView> traffic(Principal principal) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        return links.traffic().stream().map(one -> unnamed(principal, one)).toList();
    }

    /** A link is the server's; whose drone it serves is not. */
    private static LinkTrafficView unnamed(Principal principal, LinkTrafficView traffic) {
        String drone = traffic.drone();
        return drone == null || principal.sees(new DroneId(drone)) ? traffic : traffic.withoutDrone();
    }

    private static EndpointView view(VehicleEndpointGateway.Status status, @Nullable SavedEndpoint saved) {
        Instant addedAt = saved == null ? null : saved.addedAt().truncatedTo(ChronoUnit.MILLIS);
        return new EndpointView(
                status.id(),
                status.url(),
                status.transport(),
                saved == null ? "configured" : "added",
                saved == null ? null : saved.addedBy(),
                addedAt,
                status.state(),
                status.reason(),
                status.counts(),
                status.peers());
    }
}
