package org.dronemap.ws.testserver;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Bodies made from a description. */
public final class SampleBodies {
    private SampleBodies() {}

    private static final int DEEPEST = 5;

    public static JsonNode of(JsonNode schema, JsonNode description) {
        return of(schema, description, 0);
    }

    private static JsonNode of(JsonNode schema, JsonNode description, int depth) {
        JsonMapper mapper = new JsonMapper();
        JsonNode known = Optional.of(schema.path("$ref").asString(""))
                .filter(reference -> !reference.isEmpty())
                .map(reference -> description.at(reference.substring(1)))
                .orElse(schema);
        if (known.has("properties") && depth < DEEPEST) {
            ObjectNode object = mapper.createObjectNode();
            known.path("properties")
                    .properties()
                    .forEach(member -> object.set(member.getKey(), of(member.getValue(), description, depth + 1)));
            return object;
        }
        String type = known.path("type").asString("");
        return switch (type) {
            case "array" -> mapper.createArrayNode().add(of(known.path("items"), description, depth + 1));
            case "integer", "number" -> mapper.getNodeFactory().numberNode(1);
            case "boolean" -> mapper.getNodeFactory().booleanNode(true);
            case "object" -> mapper.createObjectNode();
            default -> mapper.getNodeFactory().stringNode("text");
        };
    }

    /** Where texts stand, as pointers. */
    public static List<String> texts(JsonNode node) {
        List<String> found = new ArrayList<>();
        collect(node, "", found);
        return found;
    }

    private static void collect(JsonNode node, String at, List<String> found) {
        if (node.isString()) {
            found.add(at);
        }
        node.properties().forEach(member -> collect(member.getValue(), at + "/" + member.getKey(), found));
        for (int i = 0; node.isArray() && i < node.size(); i++) {
            collect(node.get(i), at + "/" + i, found);
        }
    }

    public static JsonNode with(JsonNode usual, String at, String text) {
        JsonNode copy = usual.deepCopy();
        int last = at.lastIndexOf('/');
        JsonNode parent = copy.at(at.substring(0, last));
        String name = at.substring(last + 1);
        if (parent instanceof ObjectNode object) {
            object.put(name, text);
        } else if (parent instanceof ArrayNode array) {
            array.set(Integer.parseInt(name), text);
        }
        return copy;
    }
}
