package org.dronemap.core.stored;

import java.lang.reflect.RecordComponent;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/** Looks up the names that {@link Stored} fixes; a type without complete names is a programming error. Any thread. */
public final class StoredNames {
    private static final ClassValue<List<String>> NAMES = new ClassValue<>() {
        @Override
        protected List<String> computeValue(Class<?> type) {
            return checked(type, split(stored(type).names()), inCode(type));
        }
    };

    private StoredNames() {}

    /** The word that tells a record from others in its place. */
    public static String of(Class<?> type) {
        String name = stored(type).as();
        if (name.isEmpty()) {
            throw new IllegalStateException(type.getName() + " needs @Stored(as = …)");
        }
        return name;
    }

    /** Of components or constants, in the order of the code. */
    public static List<String> ofParts(Class<?> type) {
        return NAMES.get(type);
    }

    /** Of the components that came later. */
    public static Set<String> ofLater(Class<?> type) {
        Set<String> later = Set.copyOf(split(stored(type).later()));
        if (!ofParts(type).containsAll(later)) {
            throw new IllegalStateException("@Stored of " + type.getName() + " names not all of the later " + later);
        }
        return later;
    }

    // Names stand in the order of the constants.
    @SuppressWarnings("EnumOrdinal")
    public static String of(Enum<?> constant) {
        return ofParts(constant.getDeclaringClass()).get(constant.ordinal());
    }

    /**
     * The constant of that name.
     *
     * @throws IllegalArgumentException when there is none
     */
    public static <E extends Enum<E>> E constant(Class<E> type, String name) {
        int place = ofParts(type).indexOf(name);
        if (place < 0) {
            throw new IllegalArgumentException("there is no " + name + " among " + ofParts(type));
        }
        return type.getEnumConstants()[place];
    }

    private static Stored stored(Class<?> type) {
        Stored stored = type.getAnnotation(Stored.class);
        if (stored == null) {
            throw new IllegalStateException(type.getName() + " is stored and needs @Stored");
        }
        return stored;
    }

    private static List<String> split(String names) {
        return names.isEmpty() ? List.of() : List.of(names.split(" ", -1));
    }

    private static List<String> inCode(Class<?> type) {
        return type.isRecord()
                ? Stream.of(type.getRecordComponents())
                        .map(RecordComponent::getName)
                        .toList()
                : Stream.of(type.getEnumConstants())
                        .map(constant -> ((Enum<?>) constant).name())
                        .toList();
    }

    /** As many as the code has, each once, and none where the code has another one of that name. */
    private static List<String> checked(Class<?> type, List<String> names, List<String> inCode) {
        if (names.size() != inCode.size() || Set.copyOf(names).size() != names.size()) {
            throw new IllegalStateException("@Stored of " + type.getName() + " names " + names + " for " + inCode);
        }
        for (int place = 0; place < names.size(); place++) {
            int sameName = inCode.indexOf(names.get(place));
            if (sameName >= 0 && sameName != place) {
                throw new IllegalStateException(
                        "@Stored of " + type.getName() + " has another order than the code: " + names);
            }
        }
        return names;
    }
}
