package org.dronemap.ws.wire;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.lang.reflect.AnnotatedParameterizedType;
import java.lang.reflect.AnnotatedType;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.dronemap.ws.reading.RecordAlternatives;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/**
 * What a record looks like as JSON, a member a line: its path, its type, and whether it may be null or left out. Read off the
 * record and off two of it that were written in earnest, with all members and with those alone that must be there.
 */
final class RecordShape {
    private final JsonMapper mapper;
    private final List<String> lines = new ArrayList<>();
    private final Deque<Class<?>> within = new ArrayDeque<>();

    private RecordShape(JsonMapper mapper) {
        this.mapper = mapper;
    }

    /** The members, and one with all of them. */
    static String of(Class<?> record, JsonMapper mapper) {
        Object whole = new RecordSample(true).of(record);
        JsonNode full = mapper.valueToTree(whole);
        JsonNode least = mapper.valueToTree(new RecordSample(false).of(record));
        RecordShape shape = new RecordShape(mapper);
        shape.members("", record, full, least);
        return String.join("\n", shape.lines) + "\n\n" + PrettyJson.of(shape.told(record, full));
    }

    /** A record writes the member of the innermost choice alone, where it is of several. */
    private JsonNode told(Class<?> record, JsonNode full) {
        ObjectNode all = mapper.createObjectNode();
        RecordAlternatives.discriminators(record).forEach(all::put);
        full.forEachEntry(all::set);
        return all;
    }

    private void members(String path, Class<?> record, JsonNode full, @Nullable JsonNode least) {
        if (within.contains(record)) {
            lines.add(path + "…: as above");
            return;
        }
        within.push(record);
        List<String> known = new ArrayList<>();
        RecordAlternatives.discriminators(record).forEach((member, value) -> {
            known.add(member);
            lines.add(path + member + ": always \"" + value + "\"");
        });
        for (RecordComponent component : record.getRecordComponents()) {
            String name = nameOf(component);
            known.add(name);
            if (full.has(name)) {
                member(
                        path + name,
                        component.getAnnotatedType(),
                        full.path(name),
                        least == null ? null : least.path(name));
            }
        }
        full.forEachEntry((name, value) -> {
            if (!known.contains(name)) {
                lines.add(path + name + ": " + value.getNodeType().name().toLowerCase(Locale.ROOT) + ", made");
            }
        });
        within.pop();
    }

    private static String nameOf(RecordComponent component) {
        JsonProperty given = component.getAccessor().getAnnotation(JsonProperty.class);
        return given == null || given.value().isEmpty() ? component.getName() : given.value();
    }

    private void member(String path, AnnotatedType type, JsonNode full, @Nullable JsonNode least) {
        Class<?> raw = rawOf(type.getType());
        boolean nullable = type.isAnnotationPresent(Nullable.class);
        String absent =
                nullable && least != null && least.isMissingNode() ? " or left out" : nullable ? " or null" : "";
        lines.add(path + ": " + wordOf(raw) + absent);
        JsonNode below = nullable ? null : least;
        if (Collection.class.isAssignableFrom(raw)) {
            member(path + "[]", inner(type, 0), full.path(0), below == null ? null : below.path(0));
        } else if (Map.class.isAssignableFrom(raw)) {
            member(path + ".*", inner(type, 1), full.path("text"), below == null ? null : below.path("text"));
        } else if (raw.isRecord()) {
            members(path + ".", raw, full, below);
        } else {
            RecordAlternatives.of(raw)
                    .ifPresent(all -> all.records().forEach((name, one) -> alternative(path, name, one)));
        }
    }

    private void alternative(String path, String name, Class<?> record) {
        JsonNode whole = mapper.valueToTree(new RecordSample(true).of(record));
        members(path + "(" + name + ").", record, whole, mapper.valueToTree(new RecordSample(false).of(record)));
    }

    private static AnnotatedType inner(AnnotatedType type, int index) {
        return ((AnnotatedParameterizedType) type).getAnnotatedActualTypeArguments()[index];
    }

    static Class<?> rawOf(Type type) {
        return type instanceof ParameterizedType parameterized ? rawOf(parameterized.getRawType()) : (Class<?>) type;
    }

    private String wordOf(Class<?> raw) {
        if (raw.isEnum()) {
            return "one of "
                    + Arrays.stream(raw.getEnumConstants())
                            .map(mapper::writeValueAsString)
                            .toList();
        }
        if (raw.isRecord()
                || Map.class.isAssignableFrom(raw)
                || RecordAlternatives.of(raw).isPresent()) {
            return "object";
        }
        if (Collection.class.isAssignableFrom(raw)) {
            return "list";
        }
        return Optional.ofNullable(WORDS.get(raw)).orElseThrow(() -> new IllegalStateException("what is " + raw + "?"));
    }

    private static final Map<Class<?>, String> WORDS = Map.ofEntries(
            Map.entry(String.class, "text"),
            Map.entry(Object.class, "anything"),
            Map.entry(Instant.class, "time"),
            Map.entry(boolean.class, "true or false"),
            Map.entry(Boolean.class, "true or false"),
            Map.entry(int.class, "whole number"),
            Map.entry(Integer.class, "whole number"),
            Map.entry(long.class, "whole number"),
            Map.entry(Long.class, "whole number"),
            Map.entry(double.class, "number"),
            Map.entry(Double.class, "number"));
}
