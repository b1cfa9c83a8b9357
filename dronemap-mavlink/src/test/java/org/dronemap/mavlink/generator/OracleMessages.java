package org.dronemap.mavlink.generator;

import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** dronefleet's side of the generated messages, for tests that compare the two. */
public final class OracleMessages {
    private static final Map<String, Class<?>> TYPES = load();

    /** A field's octets in the payload. */
    public record Place(int offset, int length) {}

    private OracleMessages() {}

    public static List<String> names() {
        return MessageGenerator.MESSAGES;
    }

    public static Class<?> type(String name) {
        Class<?> type = TYPES.get(name);
        if (type == null) {
            throw new IllegalArgumentException(name + " is not among dronefleet's messages");
        }
        return type;
    }

    public static int id(Class<?> type) {
        return type.getAnnotation(MavlinkMessageInfo.class).id();
    }

    public static int longestPayload(String name) {
        return MessageSources.length(type(name));
    }

    public static int shortestPayload(String name) {
        return MessageSources.lengthWithoutExtensions(type(name));
    }

    public static List<Place> texts(String name) {
        return MessageSources.wireOrder(type(name)).stream()
                .filter(field -> field.javaType().equals("String"))
                .map(field -> new Place(field.offset(), field.unitSize() * field.count()))
                .toList();
    }

    private static Map<String, Class<?>> load() {
        try {
            return Definitions.all().values().stream()
                    .filter(type -> MessageGenerator.MESSAGES.contains(type.getSimpleName()))
                    .collect(Collectors.toMap(Class::getSimpleName, type -> type));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
