package org.dronemap.ws.journal;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/** Makes values of any type that is written down, of random parts, as its constructors let it. */
final class RandomValues {
    private static final int MOST_TRIES = 10_000;
    private static final List<Double> NUMBERS =
            List.of(0.0, -0.0, 1.0, 0.1, 0.5, 2.0, 47.39771234567, 1e-9, 488.25, 30.0, 100.0);
    private static final List<String> TEXTS = List.of("1", "a b", "“ü” \"\\\n\u0001", "🚁", "wp-7", "GUIDED");

    private final Random random;
    private String refusal = "";

    RandomValues(Random random) {
        this.random = random;
    }

    @SuppressWarnings("unchecked")
    <T> T of(Class<T> type) {
        return (T) value(type, 0);
    }

    private Object value(Type type, int depth) {
        if (type instanceof ParameterizedType generic && generic.getRawType() instanceof Class<?> raw) {
            return raw == List.class || raw == Set.class
                    ? several(raw, generic.getActualTypeArguments()[0], depth)
                    : value(raw, depth);
        }
        Class<?> plain = (Class<?>) type;
        if (plain.isEnum()) {
            return plain.getEnumConstants()[random.nextInt(plain.getEnumConstants().length)];
        }
        if (plain.isSealed()) {
            List<Class<?>> kinds = List.of(plain.getPermittedSubclasses());
            return value(kinds.get(random.nextInt(kinds.size())), depth);
        }
        return plain.isRecord() ? record(plain, depth) : scalar(plain);
    }

    private Object several(Class<?> raw, Type element, int depth) {
        List<Object> all = new ArrayList<>();
        int count = depth > 4 && random.nextInt(4) > 0 ? random.nextInt(2) : random.nextInt(4);
        for (int i = 0; i < count; i++) {
            all.add(value(element, depth + 1));
        }
        return raw == Set.class ? all.stream().collect(Collectors.toUnmodifiableSet()) : all;
    }

    private Object scalar(Class<?> type) {
        return switch (type.getSimpleName()) {
            case "String" -> TEXTS.get(random.nextInt(TEXTS.size()));
            case "Instant" ->
                Instant.ofEpochSecond(1_700_000_000L + random.nextInt(1_000_000), random.nextInt(1_000_000_000));
            case "Duration" -> Duration.ofMillis(random.nextInt(60_000));
            case "int", "Integer" -> random.nextInt(100);
            case "long", "Long" -> random.nextLong();
            case "boolean", "Boolean" -> random.nextBoolean();
            case "double", "Double" ->
                random.nextInt(10) == 0 ? Double.POSITIVE_INFINITY : NUMBERS.get(random.nextInt(NUMBERS.size()));
            default -> throw new IllegalStateException("nobody knows how to make a " + type);
        };
    }

    /** Until its constructor takes the parts. */
    private Object record(Class<?> type, int depth) {
        if (type == Geodetic.class) {
            return new Geodetic(random.nextDouble() * 0.1 + 47, random.nextDouble() * 0.1 + 8);
        }
        if (type == DroneId.class) {
            return new DroneId("drone-" + random.nextInt(1_000_000));
        }
        RecordComponent[] components = type.getRecordComponents();
        for (int attempt = 0; attempt < MOST_TRIES; attempt++) {
            @Nullable Object[] parts = new @Nullable Object[components.length];
            Class<?>[] types = new Class<?>[components.length];
            for (int i = 0; i < components.length; i++) {
                types[i] = components[i].getType();
                parts[i] = part(type, components[i], depth);
            }
            try {
                Constructor<?> constructor = type.getDeclaredConstructor(types);
                constructor.setAccessible(true);
                return constructor.newInstance(parts);
            } catch (InvocationTargetException refused) {
                refusal = String.valueOf(refused.getCause());
            } catch (ReflectiveOperationException e) {
                throw new IllegalStateException(e);
            }
        }
        throw new IllegalStateException("no " + type + " could be made: " + refusal);
    }

    private @Nullable Object part(Class<?> owner, RecordComponent component, int depth) {
        if (component.getAnnotatedType().isAnnotationPresent(Nullable.class) && random.nextInt(3) == 0) {
            return null;
        }
        if (component.getType() == String.class && owner.getSimpleName().endsWith("Id")) {
            return "name-" + random.nextInt(1_000_000);
        }
        return value(component.getGenericType(), depth + 1);
    }
}
