package org.dronemap.store.postgres;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Permission;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/** The two columns that say how far an access key reaches: words separated by commas. */
final class KeyScopeText {
    private static final String COMMA = ",";

    private KeyScopeText() {}

    static @Nullable String drones(KeyScope scope) {
        Set<DroneId> drones = scope.drones();
        return drones == null
                ? null
                : drones.stream().map(DroneId::value).sorted().collect(Collectors.joining(COMMA));
    }

    static String permissions(KeyScope scope) {
        return scope.permissions().stream().map(Permission::name).collect(Collectors.joining(COMMA));
    }

    static KeyScope scope(@Nullable String drones, String permissions) {
        EnumSet<Permission> all = EnumSet.noneOf(Permission.class);
        Arrays.stream(permissions.split(COMMA)).map(Permission::valueOf).forEach(all::add);
        return new KeyScope(drones == null ? null : ids(drones), all);
    }

    private static Set<DroneId> ids(String drones) {
        return Arrays.stream(drones.split(COMMA))
                .filter(id -> !id.isEmpty())
                .map(DroneId::new)
                .collect(Collectors.toUnmodifiableSet());
    }
}
