package org.dronemap.ws.testserver;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The bounds that a description of REST gives to members of bodies, and bodies just inside and just outside of them. */
public final class OpenApiBounds {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;
    private static final BigDecimal STEP = new BigDecimal("0.01");
    /** A text of a list that gets another number in each place. */
    private static final String UNLIKE = "unlike";

    private final JsonNode description;

    public OpenApiBounds(JsonNode description) {
        this.description = description;
    }

    /**
     * A member with a value at a bound, or just beyond it.
     *
     * @param member such as {@code GoToCommand.latitude}
     * @param field as an answer names it
     */
    public record Probe(String member, String field, boolean inside, String body) {}

    /** Where in a body, by a pointer of JSON and as an answer names it. */
    private record Place(String pointer, String field) {
        Place member(String name) {
            return new Place(pointer + "/" + name, field.isEmpty() ? name : field + "." + name);
        }

        Place element(int index) {
            return new Place(pointer + "/" + index, field + "[" + index + "]");
        }
    }

    private record Bounded(String member, Place place, JsonNode schema) {}

    /** All members with bounds of all bodies. */
    public TreeSet<String> members() {
        TreeSet<String> found = new TreeSet<>();
        TreeSet<String> seen = new TreeSet<>();
        description
                .path("paths")
                .forEach(path -> path.forEach(operation -> operation
                        .path("requestBody")
                        .path("content")
                        .forEach(content -> collect("", content.path("schema"), seen, found))));
        return found;
    }

    private void collect(String name, JsonNode schema, TreeSet<String> seen, TreeSet<String> found) {
        String reference = schema.path("$ref").asString("");
        if (!reference.isEmpty()) {
            if (seen.add(reference)) {
                collect(nameOf(reference), resolved(schema), seen, found);
            }
            return;
        }
        schema.path("properties").forEachEntry((member, one) -> {
            if (isBounded(one)) {
                found.add(name + "." + member);
            }
            collect(name + "." + member, one, seen, found);
        });
        Stream.of("oneOf", "anyOf")
                .forEach(choice -> schema.path(choice).forEach(one -> collect(name, one, seen, found)));
        if (schema.has("items")) {
            collect(name, schema.path("items"), seen, found);
        }
    }

    /** Bodies that differ from that one in one member each, for each member with bounds that it has. */
    public List<Probe> probes(String method, String path, String body) {
        JsonNode usual = new JsonMapper().readTree(body);
        JsonNode schema = description
                .path("paths")
                .path(path)
                .path(method)
                .path("requestBody")
                .path("content")
                .path("application/json")
                .path("schema");
        List<Bounded> bounded = new ArrayList<>();
        walk(schema, usual, new Place("", ""), bounded);
        return bounded.stream().flatMap(one -> probes(one, usual)).toList();
    }

    private void walk(JsonNode schema, JsonNode value, Place at, List<Bounded> found) {
        String reference = schema.path("$ref").asString("");
        if (!reference.isEmpty()) {
            walkObject(nameOf(reference), resolved(schema), value, at, found);
        } else if (schema.has("anyOf")) {
            walk(schema.path("anyOf").path(0), value, at, found);
        } else if (value.isArray()) {
            for (int index = 0; index < value.size(); index++) {
                walk(schema.path("items"), value.path(index), at.element(index), found);
            }
        }
    }

    private void walkObject(String name, JsonNode schema, JsonNode value, Place at, List<Bounded> found) {
        JsonNode choice = schema.path("discriminator");
        if (!choice.isMissingNode()) {
            String said = value.path(choice.path("propertyName").asString()).asString("");
            walk(NODES.objectNode().set("$ref", choice.path("mapping").path(said)), value, at, found);
            return;
        }
        schema.path("properties").forEachEntry((member, one) -> {
            if (value.has(member)) {
                if (isBounded(one)) {
                    found.add(new Bounded(name + "." + member, at.member(member), one));
                }
                walk(one, value.path(member), at.member(member), found);
            }
        });
    }

    private JsonNode resolved(JsonNode reference) {
        return description.at(reference.path("$ref").asString().substring(1));
    }

    private static String nameOf(String reference) {
        return reference.substring(reference.lastIndexOf('/') + 1);
    }

    static boolean isBounded(JsonNode schema) {
        return Stream.of("minimum", "maximum", "minLength", "maxLength", "minItems", "maxItems", "pattern")
                .anyMatch(schema::has);
    }

    private static Stream<Probe> probes(Bounded one, JsonNode usual) {
        JsonNode schema = one.schema();
        JsonNode value = usual.at(one.place().pointer());
        List<Probe> probes = new ArrayList<>();
        BigDecimal step = value.isIntegralNumber() && isWhole(schema) ? BigDecimal.ONE : STEP;
        for (String bound : List.of("minimum", "maximum")) {
            if (schema.has(bound)) {
                BigDecimal inside = schema.path(bound).decimalValue();
                BigDecimal outside = bound.equals("minimum") ? inside.subtract(step) : inside.add(step);
                probes.add(probe(one, usual, true, NODES.numberNode(inside)));
                probes.add(probe(one, usual, false, NODES.numberNode(outside)));
            }
        }
        for (String bound : List.of("minLength", "maxLength", "minItems", "maxItems")) {
            // Nothing is shorter than nothing.
            if (schema.path(bound).intValue(0) > 0) {
                int inside = schema.path(bound).intValue();
                int outside = inside + (bound.startsWith("min") ? -1 : 1);
                probes.add(probe(one, usual, true, sized(value, inside)));
                probes.add(probe(one, usual, false, sized(value, outside)));
            }
        }
        if (schema.has("pattern")) {
            probes.add(probe(one, usual, true, value));
            probes.add(probe(one, usual, false, NODES.stringNode(value.asString() + "!")));
        }
        return probes.stream();
    }

    private static boolean isWhole(JsonNode schema) {
        return schema.path("type").toString().contains("integer");
    }

    /** As long as that; an element more is as the last one. */
    private static JsonNode sized(JsonNode value, int size) {
        if (!value.isArray()) {
            return NODES.stringNode("x".repeat(size));
        }
        ArrayNode sized = NODES.arrayNode();
        IntStream.range(0, size).forEach(index -> {
            JsonNode element = value.path(Math.min(index, value.size() - 1));
            sized.add(element.asString("").equals(UNLIKE) ? NODES.stringNode(UNLIKE + index) : element);
        });
        return sized;
    }

    private static Probe probe(Bounded one, JsonNode usual, boolean inside, @Nullable JsonNode value) {
        JsonNode copy = usual.deepCopy();
        String pointer = one.place().pointer();
        int last = pointer.lastIndexOf('/');
        ((ObjectNode) copy.at(pointer.substring(0, last))).set(pointer.substring(last + 1), value);
        return new Probe(one.member(), one.place().field(), inside, copy.toString());
    }
}
