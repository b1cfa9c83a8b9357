package org.dronemap.ws.testserver;

import java.math.BigDecimal;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Bodies of commands, made from what the description says of each type, so that a new command needs no entry anywhere. */
public final class CommandBodies {
    private static final JsonMapper JSON = JsonMapper.shared();
    private static final String SCHEMAS = "/components/schemas/";

    /** What a description cannot know, by the name of the member. */
    private static final Map<String, JsonNode> KNOWN = Stream.of(
                    "latitude=47.3978",
                    "longitude=8.5457",
                    "altitude=20",
                    "mode=\"GUIDED\"",
                    "id=\"just-an-id\"",
                    "items=[{\"type\":\"takeOff\",\"altitude\":20},"
                            + "{\"type\":\"waypoint\",\"latitude\":47.3978,\"longitude\":8.5457,\"altitude\":20}]",
                    "parameters=[{\"name\":\"RTL_ALT\",\"value\":2000}]")
            .map(pair -> pair.split("=", 2))
            .collect(Collectors.toUnmodifiableMap(pair -> pair[0], pair -> JSON.readTree(pair[1])));

    private final JsonNode description;

    /** Of OpenAPI. */
    public CommandBodies(JsonNode description) {
        this.description = description;
    }

    /** What there is, as {@code type} says it. */
    public Set<String> types() {
        return mapping().propertyNames().stream().collect(Collectors.toUnmodifiableSet());
    }

    /** A command of that type that lacks nothing: with all members that it must have and no other. */
    public ObjectNode least(String type) {
        return body(type, false);
    }

    /** The same with all members that have a bound as well. */
    public ObjectNode bounded(String type) {
        return body(type, true);
    }

    private ObjectNode body(String type, boolean bounded) {
        JsonNode schema = description.at(mapping().path(type).asString().substring(1));
        Set<String> required =
                schema.path("required").valueStream().map(JsonNode::asString).collect(Collectors.toUnmodifiableSet());
        ObjectNode body = JSON.createObjectNode();
        schema.path("properties").forEachEntry((member, one) -> {
            if (required.contains(member) || (bounded && isBounded(one))) {
                body.set(member, value(type, member, one));
            }
        });
        return body;
    }

    private static boolean isBounded(JsonNode schema) {
        return Stream.of("minimum", "maximum", "minLength", "maxLength", "pattern", "minItems", "maxItems")
                .anyMatch(schema::has);
    }

    private static JsonNode value(String type, String member, JsonNode schema) {
        JsonNode known = KNOWN.get(member);
        if (known != null) {
            return known;
        }
        if (schema.has("enum")) {
            return schema.path("enum").path(0);
        }
        String kind = schema.path("type").toString();
        if (kind.contains("boolean")) {
            return JSON.getNodeFactory().booleanNode(false);
        }
        if (kind.contains("integer") || kind.contains("number")) {
            BigDecimal least = schema.path("minimum").asDecimal(BigDecimal.ONE);
            BigDecimal most = schema.path("maximum").asDecimal(BigDecimal.ONE);
            return JSON.getNodeFactory().numberNode(BigDecimal.ONE.max(least).min(most.max(least)));
        }
        throw new IllegalStateException(
                "What " + member + " of " + type + " may be does not follow from its description: say it above");
    }

    private JsonNode mapping() {
        return description.at(SCHEMAS + "CommandRequest/discriminator/mapping");
    }
}
