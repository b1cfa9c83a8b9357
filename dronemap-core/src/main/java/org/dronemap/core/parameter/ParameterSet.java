package org.dronemap.core.parameter;

import java.time.Instant;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/** All parameters last read from one vehicle, in order of their names; immutable. */
public final class ParameterSet {
    /** Nothing was read yet. */
    public static final ParameterSet NONE = new ParameterSet(new TreeMap<>(), null);

    private final SortedMap<String, Parameter> byName;
    private final @Nullable Instant readAt;

    private ParameterSet(SortedMap<String, Parameter> byName, @Nullable Instant readAt) {
        this.byName = Collections.unmodifiableSortedMap(byName);
        this.readAt = readAt;
    }

    /** All that a vehicle has. */
    public static ParameterSet of(Collection<Parameter> all, Instant readAt) {
        SortedMap<String, Parameter> byName = new TreeMap<>();
        all.forEach(parameter -> byName.put(parameter.name(), parameter));
        return new ParameterSet(byName, readAt);
    }

    public ParameterSet with(Parameter newer) {
        if (newer.equals(byName.get(newer.name()))) {
            return this;
        }
        SortedMap<String, Parameter> changed = new TreeMap<>(byName);
        changed.put(newer.name(), newer);
        return new ParameterSet(changed, readAt);
    }

    public Optional<Parameter> find(String name) {
        return Optional.ofNullable(byName.get(name));
    }

    public List<Parameter> all() {
        return List.copyOf(byName.values());
    }

    /** Those whose name has the words in it, whatever their case; words may come in any order. */
    public List<Parameter> search(String words) {
        List<String> wanted = List.of(words.strip().toUpperCase(Locale.ROOT).split("\\s+"));
        return byName.values().stream()
                .filter(parameter -> wanted.stream().allMatch(parameter.name().toUpperCase(Locale.ROOT)::contains))
                .toList();
    }

    public int size() {
        return byName.size();
    }

    /** When the whole list was last read; null when it never was. */
    public @Nullable Instant readAt() {
        return readAt;
    }
}
