package org.dronemap.ws.journal;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import org.dronemap.core.stored.StoredNames;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/**
 * Reads and writes a Java record in the journal of operations: each component by its stored name, in their order. Only
 * lists and what may be null may be missing, and are empty or null then: so what was written before a record had them
 * can be read still. Those that came later are left out while they are empty or null, so that it is also written as it
 * was.
 */
final class RecordValueCodec implements ValueCodec {
    private final Class<?> type;
    private final Constructor<?> constructor;
    private final List<Member> members = new ArrayList<>();

    private record Member(String name, Method accessor, ValueCodec form, boolean nullable, boolean later) {}

    RecordValueCodec(Class<?> type, ValueCodecRegistry forms) {
        this.type = type;
        RecordComponent[] components = type.getRecordComponents();
        try {
            constructor = type.getDeclaredConstructor(
                    Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new));
        } catch (NoSuchMethodException e) {
            throw new IllegalStateException(type + " is no record", e);
        }
        constructor.setAccessible(true);
        List<String> names = StoredNames.ofParts(type);
        Set<String> later = StoredNames.ofLater(type);
        for (int i = 0; i < components.length; i++) {
            RecordComponent component = components[i];
            Method accessor = component.getAccessor();
            accessor.setAccessible(true);
            members.add(new Member(
                    names.get(i),
                    accessor,
                    forms.of(component.getGenericType()),
                    component.getAnnotatedType().isAnnotationPresent(Nullable.class),
                    later.contains(names.get(i))));
        }
    }

    boolean has(String member) {
        return members.stream().anyMatch(one -> one.name().equals(member));
    }

    @Override
    public JsonNode write(Object value) {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        fill(node, value);
        return node;
    }

    void fill(ObjectNode node, Object value) {
        for (Member member : members) {
            Object part = part(member, value);
            if (part == null && !member.nullable()) {
                throw new IllegalArgumentException(at(member) + " is null");
            }
            if (member.later() && (part == null || (part instanceof Collection<?> all && all.isEmpty()))) {
                continue;
            }
            node.set(
                    member.name(),
                    part == null
                            ? JsonNodeFactory.instance.nullNode()
                            : member.form().write(part));
        }
    }

    private static @Nullable Object part(Member member, Object value) {
        try {
            return member.accessor().invoke(value);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    @Override
    public Object read(JsonNode node) {
        return read(node, 0);
    }

    /** {@code others}: how many members there are besides. */
    Object read(JsonNode node, int others) {
        long written = members.stream().filter(one -> node.has(one.name())).count();
        if (!node.isObject() || node.size() != written + others) {
            throw new IllegalArgumentException("no " + type + ": " + node);
        }
        @Nullable Object[] parts = new @Nullable Object[members.size()];
        for (int i = 0; i < parts.length; i++) {
            parts[i] = part(members.get(i), node);
        }
        try {
            return constructor.newInstance(parts);
        } catch (InvocationTargetException e) {
            throw new IllegalArgumentException("no " + type + ": " + e.getCause(), e);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    private @Nullable Object part(Member member, JsonNode node) {
        JsonNode part = node.get(member.name());
        if (part == null && member.form() instanceof CollectionValueCodec list) {
            return list.read(JsonNodeFactory.instance.arrayNode());
        }
        if (part == null && member.nullable()) {
            return null;
        }
        if (part == null || (part.isNull() && !member.nullable())) {
            throw new IllegalArgumentException(at(member) + " is missing");
        }
        return part.isNull() ? null : member.form().read(part);
    }

    private String at(Member member) {
        return member.name() + " of " + type;
    }
}
