package org.dronemap.ws.wire;

import java.util.TreeMap;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** JSON for people who read differences: a member a line. */
final class PrettyJson {
    private static final JsonMapper JSON = new JsonMapper();

    private PrettyJson() {}

    static JsonNode tree(String text) {
        return JSON.readTree(text);
    }

    static String of(JsonNode node) {
        return JSON.writerWithDefaultPrettyPrinter().writeValueAsString(node).replace("\r\n", "\n") + "\n";
    }

    /** The same with the members of each object in the order of their names. */
    static JsonNode sorted(JsonNode node) {
        if (node.isArray()) {
            ArrayNode array = JSON.createArrayNode();
            node.forEach(each -> array.add(sorted(each)));
            return array;
        }
        if (!node.isObject()) {
            return node;
        }
        TreeMap<String, JsonNode> members = new TreeMap<>();
        node.forEachEntry((name, value) -> members.put(name, sorted(value)));
        ObjectNode object = JSON.createObjectNode();
        members.forEach(object::set);
        return object;
    }
}
