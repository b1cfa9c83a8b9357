package org.dronemap.ws.journal;

import java.util.Collection;
import java.util.Map;
import java.util.TreeMap;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** One of several records, told apart by the simple name of its class, which therefore is never to change. */
final class OneOfForm implements Form {
    private static final String TYPE = "type";

    private final Class<?> base;
    private final Forms forms;
    private final Map<String, Class<?>> types = new TreeMap<>();

    OneOfForm(Class<?> base, Collection<Class<?>> all, Forms forms) {
        this.base = base;
        this.forms = forms;
        for (Class<?> one : all) {
            if (types.put(one.getSimpleName(), one) != null) {
                throw new IllegalStateException("two kinds of " + base + " are called " + one.getSimpleName());
            }
        }
    }

    @Override
    public JsonNode write(Object value) {
        Class<?> type = value.getClass();
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.put(TYPE, type.getSimpleName());
        form(type.getSimpleName()).fill(node, value);
        return node;
    }

    @Override
    public Object read(JsonNode node) {
        JsonNode type = node.get(TYPE);
        if (type == null || !type.isString()) {
            throw new IllegalArgumentException("no " + base.getSimpleName() + ": " + node);
        }
        return form(type.stringValue()).read(node, 1);
    }

    private RecordForm form(String name) {
        Class<?> type = types.get(name);
        if (type == null || !(forms.of(type) instanceof RecordForm form) || form.has(TYPE)) {
            throw new IllegalArgumentException("no kind of " + base.getSimpleName() + ": " + name);
        }
        return form;
    }
}
