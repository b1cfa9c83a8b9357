package org.dronemap.store.postgres;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Permission;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.StoredNames;
import org.jspecify.annotations.Nullable;

/** Columns that say how far rights reach: words separated by commas. */
final class KeyScopeColumns {
    private static final String COMMA = ",";

    private KeyScopeColumns() {}

    static @Nullable String drones(KeyScope scope) {
        Set<DroneId> drones = scope.drones();
        return drones == null ? null : list(drones);
    }

    static String list(Set<DroneId> drones) {
        return drones.stream().map(DroneId::value).sorted().collect(Collectors.joining(COMMA));
    }

    static String permissions(KeyScope scope) {
        return words(scope.permissions());
    }

    static String words(Set<Permission> permissions) {
        return permissions.stream().map(StoredNames::of).collect(Collectors.joining(COMMA));
    }

    static @Nullable Set<DroneId> dronesOrAll(@Nullable String drones) {
        return drones == null ? null : ids(drones);
    }

    static Set<Permission> permissions(String words) {
        EnumSet<Permission> all = EnumSet.noneOf(Permission.class);
        Arrays.stream(words.split(COMMA))
                .map(word -> StoredNames.constant(Permission.class, word))
                .forEach(all::add);
        return all;
    }

    static Set<DroneId> ids(String drones) {
        return Arrays.stream(drones.split(COMMA))
                .filter(id -> !id.isEmpty())
                .map(DroneId::new)
                .collect(Collectors.toUnmodifiableSet());
    }
}
