package org.dronemap.ws.reading;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import com.fasterxml.jackson.annotation.JsonTypeName;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The Java records that a body of the API may be, and the JSON member that tells them apart. One of them may be a
 * choice itself, by another member.
 *
 * @param member the name of that member, such as {@code type}
 * @param records by what that member says, in the order in which they are named to clients
 */
public record RecordAlternatives(String member, Map<String, Class<?>> records) {
    private static final int MOST_IN_A_SENTENCE = 9;

    /** Those of a sealed type; empty: what is written as that type is of one form. */
    public static Optional<RecordAlternatives> of(Class<?> type) {
        JsonTypeInfo told = type.getDeclaredAnnotation(JsonTypeInfo.class);
        JsonSubTypes named = type.getDeclaredAnnotation(JsonSubTypes.class);
        if (!type.isSealed() || told == null || named == null) {
            return Optional.empty();
        }
        Map<String, Class<?>> records = new LinkedHashMap<>();
        for (JsonSubTypes.Type one : named.value()) {
            of(one.value())
                    .filter(more -> more.member().equals(told.property()))
                    .ifPresentOrElse(
                            more -> records.putAll(more.records()), () -> records.put(one.name(), one.value()));
        }
        return Optional.of(new RecordAlternatives(told.property(), records));
    }

    /**
     * Those that a record is one of, and itself where it is declared elsewhere and named by {@code @JsonTypeName}; empty: it
     * is none.
     */
    public static Optional<RecordAlternatives> with(Class<?> record) {
        return interfaces(record).flatMap(type -> of(type).stream()).findFirst().map(all -> all.and(record));
    }

    /** What tells a record apart from others: member by member, the outermost choice first. Empty: it is one of none. */
    public static Map<String, String> discriminators(Class<?> record) {
        List<Class<?>> choices = new ArrayList<>(interfaces(record).toList());
        List<Class<?>> forms =
                Stream.concat(Stream.of(record), choices.stream()).toList();
        Collections.reverse(choices);
        Map<String, String> told = new LinkedHashMap<>();
        choices.stream()
                .flatMap(type -> of(type).stream())
                .forEach(all -> all.and(record).records.forEach((name, form) -> {
                    if (forms.contains(form)) {
                        told.put(all.member(), name);
                    }
                }));
        return told;
    }

    private static Stream<Class<?>> interfaces(Class<?> type) {
        return Arrays.stream(type.getInterfaces()).flatMap(one -> Stream.concat(Stream.of(one), interfaces(one)));
    }

    private RecordAlternatives and(Class<?> record) {
        JsonTypeName own = record.getDeclaredAnnotation(JsonTypeName.class);
        if (own == null || records.containsValue(record)) {
            return this;
        }
        Map<String, Class<?>> more = new LinkedHashMap<>(records);
        more.putIfAbsent(own.value(), record);
        return new RecordAlternatives(member, more);
    }

    /** What the member says where it is that record. */
    public String nameOf(Class<?> record) {
        return records.entrySet().stream()
                .filter(one -> one.getValue() == record)
                .map(Map.Entry::getKey)
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(record + " has no name among " + records.keySet()));
    }

    /** What the member may say, in words for people. */
    public String allowed() {
        List<String> names = List.copyOf(records.keySet());
        int last = names.size() - 1;
        return names.size() > MOST_IN_A_SENTENCE || last == 0
                ? "one of " + String.join(", ", names)
                : String.join(", ", names.subList(0, last)) + " or " + names.get(last);
    }
}
