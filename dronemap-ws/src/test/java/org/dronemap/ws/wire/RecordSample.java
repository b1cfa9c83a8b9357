package org.dronemap.ws.wire;

import java.lang.reflect.AnnotatedParameterizedType;
import java.lang.reflect.AnnotatedType;
import java.lang.reflect.Constructor;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.ws.reading.RecordAlternatives;
import org.jspecify.annotations.Nullable;

/** Makes records whose members are always the same. */
final class RecordSample {
    private static final Instant AT = Instant.parse("2026-01-31T12:00:00.250Z");

    private final boolean all;
    private final Deque<Class<?>> within = new ArrayDeque<>();

    /** {@code all}: also what may be null. */
    RecordSample(boolean all) {
        this.all = all;
    }

    /** By the constructor that wants least: what it fills in itself, such as a message's type, is always so. */
    Object of(Class<?> record) {
        Constructor<?> least = Arrays.stream(record.getDeclaredConstructors())
                .min(Comparator.comparingInt(Constructor::getParameterCount))
                .orElseThrow();
        return made(least);
    }

    private Object made(Constructor<?> constructor) {
        Class<?> owner = constructor.getDeclaringClass();
        within.push(owner);
        constructor.setAccessible(true);
        Object[] values = Arrays.stream(constructor.getAnnotatedParameterTypes())
                .map(this::value)
                .toArray();
        within.pop();
        try {
            return constructor.newInstance(values);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("no sample of " + owner, e);
        }
    }

    private @Nullable Object value(AnnotatedType type) {
        if (type.isAnnotationPresent(Nullable.class) && !all) {
            return null;
        }
        Class<?> raw = RecordShape.rawOf(type.getType());
        if (Collection.class.isAssignableFrom(raw)) {
            return collection(raw, inner(type, 0));
        }
        if (Map.class.isAssignableFrom(raw)) {
            Object value = value(inner(type, 1));
            return value == null ? Map.of() : Map.of("text", value);
        }
        if (raw.isRecord()) {
            return within.contains(raw) ? null : made(canonical(raw));
        }
        Class<?> alternative = RecordAlternatives.of(raw)
                .map(all -> all.records().values().iterator().next())
                .orElse(null);
        if (alternative != null) {
            return made(canonical(alternative));
        }
        return raw.isEnum() ? raw.getEnumConstants()[0] : plain(raw);
    }

    private Object collection(Class<?> raw, AnnotatedType element) {
        Object value = value(element);
        if (value == null) {
            return raw == Set.class ? Set.of() : List.of();
        }
        return raw == Set.class ? Set.of(value) : List.of(value);
    }

    private static AnnotatedType inner(AnnotatedType type, int index) {
        return ((AnnotatedParameterizedType) type).getAnnotatedActualTypeArguments()[index];
    }

    private static Constructor<?> canonical(Class<?> record) {
        Class<?>[] types = Arrays.stream(record.getRecordComponents())
                .map(java.lang.reflect.RecordComponent::getType)
                .toArray(Class<?>[]::new);
        try {
            return record.getDeclaredConstructor(types);
        } catch (NoSuchMethodException e) {
            throw new IllegalStateException(e);
        }
    }

    private static Object plain(Class<?> raw) {
        if (raw == String.class || raw == Object.class) {
            return "text";
        }
        if (raw == Instant.class) {
            return AT;
        }
        if (raw == boolean.class || raw == Boolean.class) {
            return true;
        }
        if (raw == double.class || raw == Double.class) {
            return 1.5;
        }
        return raw == long.class || raw == Long.class ? (Object) 7L : (Object) 7;
    }
}
