package org.dronemap.ws.journal;

import java.util.Collection;
import java.util.Map;
import java.util.TreeMap;
import org.dronemap.core.stored.StoredNames;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** Reads and writes values of a sealed interface in the journal of operations, with the name of their record. */
final class SealedInterfaceCodec implements ValueCodec {
    private static final String TYPE = "type";

    private final Class<?> base;
    private final ValueCodecRegistry forms;
    private final Map<String, Class<?>> types = new TreeMap<>();

    SealedInterfaceCodec(Class<?> base, Collection<Class<?>> all, ValueCodecRegistry forms) {
        this.base = base;
        this.forms = forms;
        for (Class<?> one : all) {
            if (types.put(StoredNames.of(one), one) != null) {
                throw new IllegalStateException("two kinds of " + base + " are stored as " + StoredNames.of(one));
            }
        }
    }

    @Override
    public JsonNode write(Object value) {
        String name = StoredNames.of(value.getClass());
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.put(TYPE, name);
        form(name).fill(node, value);
        return node;
    }

    @Override
    public Object read(JsonNode node) {
        JsonNode type = node.get(TYPE);
        if (type == null || !type.isString()) {
            throw new IllegalArgumentException("no " + base + ": " + node);
        }
        return form(type.stringValue()).read(node, 1);
    }

    private RecordValueCodec form(String name) {
        Class<?> type = types.get(name);
        if (type == null || !(forms.of(type) instanceof RecordValueCodec form) || form.has(TYPE)) {
            throw new IllegalArgumentException("no kind of " + base + ": " + name);
        }
        return form;
    }
}
