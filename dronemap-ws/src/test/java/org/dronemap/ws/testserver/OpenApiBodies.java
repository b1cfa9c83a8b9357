package org.dronemap.ws.testserver;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** Bodies that are made of what a description of REST says of them: with each member that has to be there or has a bound. */
public final class OpenApiBodies {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;
    private static final String JSON = "application/json";
    private static final int MOST_DEPTH = 8;

    private final JsonNode description;

    public OpenApiBodies(JsonNode description) {
        this.description = description;
    }

    /** Of an operation such as {@code PUT /api/v1/drones/{id}}; empty: it takes none, or one of another type than JSON. */
    public Optional<JsonNode> of(String operation) {
        JsonNode content = at(operation).path("requestBody").path("content").path(JSON);
        return content.isMissingNode() ? Optional.empty() : Optional.of(value(content.path("schema"), MOST_DEPTH));
    }

    /** All that take a body of JSON, such as {@code PUT /api/v1/drones/{id}}. */
    public List<String> operations() {
        List<String> found = new ArrayList<>();
        description
                .path("paths")
                .forEachEntry((path, all) -> all.forEachEntry((method, operation) -> {
                    if (operation.path("requestBody").path("content").has(JSON)) {
                        found.add(method.toUpperCase(Locale.ROOT) + " " + path);
                    }
                }));
        return found;
    }

    /** Whether it needs nothing but its address and a body of JSON, if any. */
    public boolean isPlain(String operation) {
        JsonNode described = at(operation);
        JsonNode body = described.path("requestBody").path("content");
        boolean otherBody = body.size() > 0 && !body.has(JSON);
        boolean otherNeeds = false;
        for (JsonNode parameter : described.path("parameters")) {
            otherNeeds |= parameter.path("required").asBoolean(false)
                    && !parameter.path("in").asString("").equals("path");
        }
        return !described.isMissingNode() && !otherBody && !otherNeeds;
    }

    private JsonNode at(String operation) {
        String[] words = operation.split(" ");
        return description.path("paths").path(words[1]).path(words[0].toLowerCase(Locale.ROOT));
    }

    private JsonNode value(JsonNode schema, int depth) {
        String reference = schema.path("$ref").asString("");
        if (!reference.isEmpty()) {
            return value(description.at(reference.substring(1)), depth);
        }
        for (String choice : new String[] {"oneOf", "anyOf"}) {
            if (schema.has(choice)) {
                return value(schema.path(choice).path(0), depth);
            }
        }
        for (String given : new String[] {"example", "const"}) {
            if (schema.has(given)) {
                return schema.path(given);
            }
        }
        if (schema.has("enum")) {
            return schema.path("enum").path(0);
        }
        return switch (type(schema)) {
            case "object" -> object(schema, depth);
            case "array" -> array(schema, depth);
            case "integer", "number" -> number(schema);
            case "boolean" -> NODES.booleanNode(false);
            default -> text(schema);
        };
    }

    private static String type(JsonNode schema) {
        JsonNode type = schema.path("type");
        return type.isArray() ? type.path(0).asString("") : type.asString(schema.has("properties") ? "object" : "");
    }

    private ObjectNode object(JsonNode schema, int depth) {
        TreeSet<String> needed = new TreeSet<>();
        schema.path("required").forEach(name -> needed.add(name.asString()));
        ObjectNode made = NODES.objectNode();
        schema.path("properties").forEachEntry((name, member) -> {
            if (depth > 0 && (needed.contains(name) || OpenApiBounds.isBounded(member))) {
                made.set(name, value(member, depth - 1));
            }
        });
        return made;
    }

    private ArrayNode array(JsonNode schema, int depth) {
        ArrayNode made = NODES.arrayNode();
        for (int i = 0; i < schema.path("minItems").intValue(0); i++) {
            made.add(value(schema.path("items"), depth - 1));
        }
        return made;
    }

    private static JsonNode number(JsonNode schema) {
        @Nullable
        JsonNode bound =
                schema.has("minimum") ? schema.path("minimum") : schema.has("maximum") ? schema.path("maximum") : null;
        return bound == null ? NODES.numberNode(1) : bound;
    }

    private static JsonNode text(JsonNode schema) {
        String text = "x".repeat(Math.max(1, schema.path("minLength").intValue(0)));
        return NODES.stringNode(text);
    }
}
