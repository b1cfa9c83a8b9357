package org.dronemap.ws.journal;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;

/**
 * Reads and writes a list or a set in the journal of operations; sets are sorted, so that equal sets give equal text.
 */
final class CollectionValueCodec implements ValueCodec {
    private final ValueCodec element;
    private final boolean distinct;

    CollectionValueCodec(ValueCodec element, boolean distinct) {
        this.element = element;
        this.distinct = distinct;
    }

    @Override
    public JsonNode write(Object value) {
        List<JsonNode> nodes = new ArrayList<>();
        for (Object one : (Collection<?>) value) {
            nodes.add(element.write(one));
        }
        if (distinct) {
            nodes.sort(Comparator.comparing(JsonNode::toString));
        }
        ArrayNode array = JsonNodeFactory.instance.arrayNode();
        array.addAll(nodes);
        return array;
    }

    @Override
    public Object read(JsonNode node) {
        if (!node.isArray()) {
            throw new IllegalArgumentException("no list: " + node);
        }
        List<Object> all = new ArrayList<>(node.size());
        for (JsonNode one : node) {
            all.add(element.read(one));
        }
        if (!distinct) {
            return List.copyOf(all);
        }
        Set<Object> set = new LinkedHashSet<>(all);
        if (set.size() != all.size()) {
            throw new IllegalArgumentException("twice in a set: " + node);
        }
        return set;
    }
}
