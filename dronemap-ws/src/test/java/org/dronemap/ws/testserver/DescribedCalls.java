package org.dronemap.ws.testserver;

import java.net.http.HttpRequest;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import tools.jackson.databind.JsonNode;

/** What is done with a drone and needs nothing but what the description says of its body; last, after what has a recipe. */
public final class DescribedCalls extends SuccessfulCalls {
    private static final Pattern OF_DRONE = Pattern.compile("(POST|PUT|PATCH|DELETE) /api/v1/drones/\\{id}(/[a-z-]+)*");

    private final OpenApiBodies bodies;
    private final OrganisationMember other;
    private final String drone;

    public DescribedCalls(TestServer house, OrganisationFixture estate, OrganisationMember other) {
        super(house, estate.administrator());
        this.bodies = new OpenApiBodies(nobody.get("/api/openapi.json").json());
        this.other = other;
        this.drone = estate.drone().id();
    }

    /** Where that is not enough the call fails, and has to be given a recipe. */
    @Override
    public Optional<PreparedCall> of(String operation) {
        if (!OF_DRONE.matcher(operation).matches() || !bodies.isPlain(operation)) {
            return Optional.empty();
        }
        for (OrganisationMember one : List.of(root, other)) {
            one.http().send("/api/v1/drones/" + drone + "/control", HttpRequest.Builder::DELETE);
        }
        String[] words = operation.split(" ");
        String path = words[1].replaceFirst("^/api/v1/", "").replace("{id}", drone);
        return Optional.of(deed(
                words[0], path, bodies.of(operation).map(JsonNode::toString).orElse("")));
    }
}
