package org.dronemap.ws.key;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.FlightBounds;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/**
 * An access key for programs as its owner sees it; the secret itself is shown once only.
 *
 * @param operations what it may be used for: view, plan, command, administer
 * @param drones null: all
 * @param area that flights stay within; null: anywhere
 * @param floor in metres, as the ceiling; null: no bound on that side
 * @param altitudeReference what both are measured from: home or amsl; null: neither is there
 * @param expiresAt null: it does not end by itself
 * @param parent the key that it was made with; null: none
 * @param lastUsedAt to about a minute; null: not used yet
 * @param key the key itself, there once, in the answer that made it
 */
@Schema(name = "KeyView")
public record AccessKeyView(
        String id,
        String label,
        @EnumValues(Role.class) String role,
        @EnumValues(Permission.class) List<String> operations,
        @Nullable List<String> drones,
        @Nullable AccessKeyArea area,
        @Nullable Double floor,
        @Nullable Double ceiling,
        @EnumValues(Altitude.Reference.class) @Nullable String altitudeReference,
        @Nullable Instant expiresAt,
        @Nullable String parent,
        Instant createdAt,
        @Nullable Instant lastUsedAt,
        @Nullable String key) {
    private static final FlightBounds NONE = new FlightBounds(null, AltitudeBand.ALL);

    static AccessKeyView of(AccessKey key, @Nullable String secret) {
        KeyScope scope = key.rights().scope();
        Set<DroneId> drones = scope.drones();
        FlightBounds bounds = Objects.requireNonNullElse(scope.innermost(), NONE);
        AltitudeBand band = bounds.band();
        return new AccessKeyView(
                key.id(),
                key.label(),
                WireNames.camel(key.rights().role()),
                scope.permissions().stream().map(WireNames::camel).toList(),
                drones == null
                        ? null
                        : drones.stream().map(DroneId::value).sorted().toList(),
                AccessKeyArea.of(bounds.area()),
                band.floorMeters(),
                band.ceilingMeters(),
                band.isBounded() ? WireNames.camel(band.reference()) : null,
                millis(key.rights().expiresAt()),
                key.parent(),
                key.createdAt().truncatedTo(ChronoUnit.MILLIS),
                millis(key.lastUsedAt()),
                secret);
    }

    private static @Nullable Instant millis(@Nullable Instant time) {
        return time == null ? null : time.truncatedTo(ChronoUnit.MILLIS);
    }

    /** It may hold the key itself. */
    @Override
    public String toString() {
        return "KeyView[" + id + "]";
    }
}
