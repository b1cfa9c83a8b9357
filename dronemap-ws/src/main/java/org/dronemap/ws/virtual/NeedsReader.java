package org.dronemap.ws.virtual;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.virtual.Area;
import org.dronemap.core.virtual.Needs;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.Ranges;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Turns the needs that a client wrote into needs, or says which member is wrong. */
final class NeedsReader {
    private static final String KINDS = names(VehicleKind.values());
    private static final String CAPABILITIES = names(Capability.values());

    private NeedsReader() {}

    static Needs read(VirtualDroneRequest.@Nullable NeedsView needs) {
        if (needs == null) {
            return Needs.NONE;
        }
        Integer minutes = needs.enduranceMinutes();
        if (minutes != null && (minutes < 1 || minutes > Needs.LONGEST_ENDURANCE_MINUTES)) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    "needs.enduranceMinutes",
                    "1 to " + Needs.LONGEST_ENDURANCE_MINUTES + " minutes",
                    minutes,
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(Needs.LONGEST_ENDURANCE_MINUTES),
                    ProblemParameter.UNIT.is("minutes"));
        }
        return new Needs(kind(needs.kind()), capabilities(needs.capabilities()), minutes, area(needs.area()));
    }

    static VirtualDroneRequest.NeedsView view(Needs needs) {
        VehicleKind kind = needs.kind();
        Area area = needs.area();
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

    private static @Nullable Area area(VirtualDroneRequest.@Nullable AreaView area) {
        return area == null
                ? null
                : new Area(
                        new Geodetic(
                                Ranges.latitude("needs.area.latitude", area.latitude()),
                                Ranges.longitude("needs.area.longitude", area.longitude())),
                        Ranges.radius("needs.area.radius", area.radius()));
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
