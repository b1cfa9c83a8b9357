package org.dronemap.ws.key;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.Size;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.dronemap.core.access.KeyRights;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.FlightBounds;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.AltitudeBandReader;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/**
 * A request to create an access key for programs, with its role, drones, area and lifetime, as its owner writes it.
 * What is left out is as wide as who asks: the role, all operations, all drones, everywhere, no end.
 *
 * @param operations of view, plan, command, administer; view always is among them
 * @param area that flights stay within
 * @param floor in metres, as the ceiling
 * @param altitudeReference what both are measured from: home or amsl
 * @param days until it ends
 */
@Schema(name = "KeyRequest")
public record AccessKeyRequest(
        @Size(min = 1, max = AccessKeyRequest.LONGEST_LABEL) @Nullable
        String label,

        @EnumValues(Role.class) @Nullable String role,
        @EnumValues(Permission.class) @Nullable List<@Nullable String> operations,

        @Size(min = 1, max = AccessKeyRequest.MOST_DRONES) @Nullable
        List<@Nullable String> drones,

        @Nullable AccessKeyArea area,

        @Min(Altitude.LOWEST_PLANNED_METERS) @Max(Altitude.HIGHEST_PLANNED_METERS) @Nullable
        Double floor,

        @Min(Altitude.LOWEST_PLANNED_METERS) @Max(Altitude.HIGHEST_PLANNED_METERS) @Nullable
        Double ceiling,

        @EnumValues(Altitude.Reference.class) @Nullable String altitudeReference,
        @Min(1) @Max(AccessKeyRequest.MOST_DAYS) @Nullable Integer days) {
    static final int LONGEST_LABEL = 60;
    public static final String OPERATIONS = "a list of view, plan, command and administer";
    static final int MOST_DRONES = 500;
    static final int MOST_DAYS = 3650;

    /** Within {@code widest}, from which comes what was left out. */
    KeyRights rights(KeyRights widest, Instant now) {
        KeyScope scope = bounded(new KeyScope(
                drones == null ? widest.scope().drones() : ids(drones),
                operations == null ? widest.scope().permissions() : permissions(operations),
                widest.scope().bounds()));
        Role asked = role == null ? widest.role() : RoleChecks.named(role);
        return new KeyRights(
                asked, scope, days == null ? widest.expiresAt() : now.plus(Duration.ofDays(checked(days))));
    }

    /** Area, floor and ceiling are each as wide as before when they are left out. */
    private KeyScope bounded(KeyScope widest) {
        if (area == null && floor == null && ceiling == null) {
            return widest;
        }
        FlightBounds outer = widest.innermost();
        AltitudeBand heights = outer == null ? AltitudeBand.ALL : outer.band();
        FenceArea inherited = outer == null ? null : outer.area();
        return widest.boundedBy(new FlightBounds(area == null ? inherited : area.shape(), band(heights)));
    }

    private AltitudeBand band(AltitudeBand outer) {
        if (!outer.isBounded()) {
            return new AltitudeBandReader("").band(floor, ceiling, altitudeReference);
        }
        String reference = WireNames.camel(outer.reference());
        if (altitudeReference != null && !altitudeReference.equals(reference)) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_NOT_ALLOWED,
                    "altitudeReference",
                    reference + ", as for the key that it is made with",
                    "\"" + altitudeReference + "\"");
        }
        return new AltitudeBandReader("")
                .band(within("floor", floor, outer), within("ceiling", ceiling, outer), reference);
    }

    private static @Nullable Double within(String field, @Nullable Double meters, AltitudeBand outer) {
        if (meters == null) {
            return field.equals("floor") ? outer.floorMeters() : outer.ceilingMeters();
        }
        if (!(meters >= outer.lowMeters() && meters <= outer.highMeters())) {
            throw InvalidInput.outside(
                    ValueProblem.KEY_BOUNDS_TOO_WIDE,
                    field,
                    outer.words() + ", as for the key that it is made with",
                    meters + " m");
        }
        return meters;
    }

    private static int checked(int days) {
        if (days < 1 || days > MOST_DAYS) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    "days",
                    "1 to " + MOST_DAYS,
                    days,
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(MOST_DAYS),
                    ProblemParameter.UNIT.is("days"));
        }
        return days;
    }

    private static Set<DroneId> ids(List<@Nullable String> drones) {
        String allowed = "1 to " + MOST_DRONES + " ids of drones";
        if (drones.isEmpty() || drones.size() > MOST_DRONES) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    "drones",
                    allowed,
                    drones.size() + " ids",
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(MOST_DRONES));
        }
        Set<DroneId> ids = new LinkedHashSet<>();
        for (String drone : drones) {
            if (drone == null) {
                throw InvalidInput.outside(ValueProblem.VALUE_MALFORMED, "drones", allowed, "null");
            }
            try {
                ids.add(new DroneId(drone));
            } catch (IllegalArgumentException notAnId) {
                throw InvalidInput.outside(ValueProblem.VALUE_MALFORMED, "drones", allowed, "\"" + drone + "\"");
            }
        }
        return ids;
    }

    public static Set<Permission> permissions(List<@Nullable String> operations) {
        EnumSet<Permission> permissions = EnumSet.noneOf(Permission.class);
        for (String operation : operations) {
            permissions.add(Arrays.stream(Permission.values())
                    .filter(permission -> WireNames.camel(permission).equals(operation))
                    .findFirst()
                    .orElseThrow(() -> InvalidInput.outside(
                            ValueProblem.VALUE_NOT_ALLOWED, "operations", OPERATIONS, "\"" + operation + "\"")));
        }
        return permissions;
    }
}
