package org.dronemap.mavlink.dronefleet;

import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.dronemap.mavlink.generator.DefinitionReader;
import org.dronemap.mavlink.generator.MessageDefinition;

/** dronefleet's side of the generated messages, for tests that compare the two. */
public final class OracleMessages {
    static final Map<String, MessageDefinition> DEFINITIONS = new TreeMap<>();
    private static final Map<String, Class<?>> TYPES;

    static {
        try {
            for (MessageDefinition definition : DefinitionReader.read(Path.of("src/main/mavlink/definitions.txt"))) {
                DEFINITIONS.put(definition.recordName(), definition);
            }
            TYPES = DronefleetMessages.all().values().stream()
                    .filter(type -> DEFINITIONS.containsKey(type.getSimpleName()))
                    .collect(Collectors.toMap(Class::getSimpleName, type -> type));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A field's octets in the payload. */
    public record Place(String name, int offset, int length) {}

    private OracleMessages() {}

    public static List<String> names() {
        return List.copyOf(DEFINITIONS.keySet());
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
        return DronefleetLayout.length(type(name));
    }

    public static int shortestPayload(String name) {
        return DronefleetLayout.lengthWithoutExtensions(type(name));
    }

    /** Of all fields, as on the wire. */
    static List<Place> places(String name) {
        return places(name, all -> true);
    }

    public static List<Place> texts(String name) {
        return places(name, DronefleetLayout.Field::text);
    }

    private static List<Place> places(String name, Predicate<DronefleetLayout.Field> wanted) {
        return DronefleetLayout.wireOrder(type(name)).stream()
                .filter(wanted)
                .map(field -> new Place(field.name(), field.offset(), field.length()))
                .toList();
    }
}
