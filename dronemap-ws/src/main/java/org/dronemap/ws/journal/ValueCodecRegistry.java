package org.dronemap.ws.journal;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.dronemap.core.stored.StoredNames;
import tools.jackson.databind.JsonNode;

/**
 * Finds or builds the journal codec of a Java type: records by their components, sealed interfaces by their records.
 * Any thread.
 */
final class ValueCodecRegistry {
    private final Map<Class<?>, List<Class<?>>> open;
    private final ConcurrentHashMap<Type, ValueCodec> known = new ConcurrentHashMap<>();

    /** {@code open}: of interfaces that are not sealed, the records that are written. */
    ValueCodecRegistry(Map<Class<?>, List<Class<?>>> open) {
        this.open = Map.copyOf(open);
    }

    ValueCodec of(Type type) {
        ValueCodec form = known.get(type);
        if (form == null) {
            form = make(type);
            known.putIfAbsent(type, form);
        }
        return form;
    }

    /** Fails for whatever has no stored name, wherever in these it may occur. */
    void requireNames(Type... types) {
        Set<Type> seen = new HashSet<>();
        Deque<Type> open = new ArrayDeque<>(List.of(types));
        while (!open.isEmpty()) {
            Type type = open.remove();
            if (seen.add(type)) {
                open.addAll(type instanceof Class<?> plain ? named(plain) : parts(type));
            }
        }
    }

    private static List<Type> parts(Type type) {
        return type instanceof ParameterizedType generic
                ? Stream.concat(Stream.of(generic.getRawType()), Stream.of(generic.getActualTypeArguments()))
                        .toList()
                : List.of();
    }

    /** What it is made of. */
    private List<Type> named(Class<?> type) {
        if (type.isRecord()) {
            StoredNames.ofParts(type);
            return Stream.of(type.getRecordComponents())
                    .map(RecordComponent::getGenericType)
                    .toList();
        }
        if (type.isEnum()) {
            StoredNames.ofParts(type);
            return List.of();
        }
        List<Class<?>> kinds = kinds(type);
        kinds.forEach(StoredNames::of);
        return List.copyOf(kinds);
    }

    private ValueCodec make(Type type) {
        if (type instanceof ParameterizedType generic && generic.getRawType() instanceof Class<?> raw) {
            Type[] arguments = generic.getActualTypeArguments();
            return raw == List.class || raw == Set.class
                    ? new CollectionValueCodec(later(arguments[0]), raw == Set.class)
                    : of(raw);
        }
        if (!(type instanceof Class<?> plain)) {
            throw new IllegalStateException("nobody knows how to write a " + type);
        }
        return ScalarValueCodecs.of(plain).orElseGet(() -> composed(plain));
    }

    private ValueCodec composed(Class<?> type) {
        if (type.isRecord()) {
            return new RecordValueCodec(type, this);
        }
        List<Class<?>> records = kinds(type);
        if (records.isEmpty() && !open.containsKey(type)) {
            throw new IllegalStateException("nobody knows how to write a " + type);
        }
        return new SealedInterfaceCodec(type, records, this);
    }

    private List<Class<?>> kinds(Class<?> type) {
        List<Class<?>> records = new ArrayList<>(open.getOrDefault(type, List.of()));
        addRecords(type, records);
        return records;
    }

    private static void addRecords(Class<?> type, List<Class<?>> records) {
        if (!type.isSealed()) {
            return;
        }
        for (Class<?> one : type.getPermittedSubclasses()) {
            if (one.isRecord()) {
                records.add(one);
            } else {
                addRecords(one, records);
            }
        }
    }

    /** Found when it is needed: types may contain each other. */
    private ValueCodec later(Type type) {
        return new ValueCodec() {
            @Override
            public JsonNode write(Object value) {
                return of(type).write(value);
            }

            @Override
            public Object read(JsonNode node) {
                return of(type).read(node);
            }
        };
    }
}
