package org.dronemap.ws.virtual;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.virtual.DroneRequirements;
import org.dronemap.core.virtual.RequiredArea;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.FieldRanges;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Turns a client's requirements on the drone that serves a virtual drone into core ones, or rejects the field. */
final class DroneRequirementsReader {
    private static final String KINDS = names(VehicleKind.values());
    private static final String CAPABILITIES = names(Capability.values());

    private DroneRequirementsReader() {}

    static DroneRequirements read(VirtualDroneRequest.@Nullable NeedsView needs) {
        if (needs == null) {
            return DroneRequirements.NONE;
        }
        Integer minutes = needs.enduranceMinutes();
        if (minutes != null && (minutes < 1 || minutes > DroneRequirements.LONGEST_ENDURANCE_MINUTES)) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    "needs.enduranceMinutes",
                    "1 to " + DroneRequirements.LONGEST_ENDURANCE_MINUTES + " minutes",
                    minutes,
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(DroneRequirements.LONGEST_ENDURANCE_MINUTES),
                    ProblemParameter.UNIT.is("minutes"));
        }
        return new DroneRequirements(
                kind(needs.kind()), capabilities(needs.capabilities()), minutes, area(needs.area()));
    }

    static VirtualDroneRequest.NeedsView view(DroneRequirements needs) {
        VehicleKind kind = needs.kind();
        RequiredArea area = needs.area();
        return new VirtualDroneRequest.NeedsView(
                kind == null ? null : WireNames.camel(kind),
                needs.capabilities().stream().map(WireNames::camel).sorted().toList(),
                needs.enduranceMinutes(),
                area == null
                        ? null
                        : new VirtualDroneRequest.AreaView(
                                area.center().latitudeDegrees(),
                                area.center().longitudeDegrees(),
                                area.radiusMeters()));
    }

    private static @Nullable VehicleKind kind(@Nullable String name) {
        return name == null ? null : named("needs.kind", name, VehicleKind.values(), KINDS);
    }

    private static Set<Capability> capabilities(@Nullable List<@Nullable String> names) {
        EnumSet<Capability> capabilities = EnumSet.noneOf(Capability.class);
        for (int index = 0; names != null && index < names.size(); index++) {
            String field = "needs.capabilities[" + index + "]";
            capabilities.add(named(field, String.valueOf(names.get(index)), Capability.values(), CAPABILITIES));
        }
        return capabilities;
    }

    private static @Nullable RequiredArea area(VirtualDroneRequest.@Nullable AreaView area) {
        return area == null
                ? null
                : new RequiredArea(
                        new Geodetic(
                                FieldRanges.latitude("needs.area.latitude", area.latitude()),
                                FieldRanges.longitude("needs.area.longitude", area.longitude())),
                        FieldRanges.radius("needs.area.radius", area.radius()));
    }

    private static <E extends Enum<E>> E named(String field, String name, E[] all, String allowed) {
        return Arrays.stream(all)
                .filter(one -> WireNames.camel(one).equals(name))
                .findFirst()
                .orElseThrow(
                        () -> InvalidInput.outside(ValueProblem.VALUE_NOT_ALLOWED, field, allowed, "\"" + name + "\""));
    }

    private static String names(Enum<?>[] all) {
        return Arrays.stream(all).map(WireNames::camel).collect(Collectors.joining(", "));
    }
}
