package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.command.Command;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.jspecify.annotations.Nullable;

/** The fence that an ArduPilot vehicle keeps by its parameters, as far as it says: a height, a circle, areas. */
record FenceParameters(FencedGoTo.Values values) {
    private static final String ENABLE = "FENCE_ENABLE";
    private static final String TYPE = "FENCE_TYPE";
    private static final String RADIUS = "FENCE_RADIUS";
    private static final String HIGHEST = "FENCE_ALT_MAX";
    private static final int BY_HEIGHT = 1;
    private static final int BY_CIRCLE = 2;
    private static final int BY_AREAS = 4;
    private static final double E7 = 1e7;

    static List<List<String>> names() {
        return Stream.of(ENABLE, TYPE, RADIUS, HIGHEST).map(List::of).toList();
    }

    /** Why the place is outside of it; empty: it is not, as far as is known. */
    Optional<String> against(VehicleStatus status, Command.GoTo command) {
        int type = values.of(TYPE).map(Double::intValue).orElse(0);
        if (values.of(ENABLE).orElse(0.0) != 1) {
            return Optional.empty();
        }
        return tooHigh(type, status, command)
                .or(() -> tooFar(type, status, command.point()))
                .or(() -> (type & BY_AREAS) == 0
                        ? Optional.empty()
                        : Optional.of("Its own fence has areas (FENCE_TYPE " + type
                                + "), and the place may lie outside of them; read its fence."));
    }

    private Optional<String> tooHigh(int type, VehicleStatus status, Command.GoTo command) {
        Double above = aboveHome(status, command.altitude());
        Optional<Double> most = values.of(HIGHEST);
        if ((type & BY_HEIGHT) == 0 || above == null || most.isEmpty() || above <= most.get()) {
            return Optional.empty();
        }
        return Optional.of(String.format(
                Locale.ROOT,
                "The place is %.0f m above its home, and its own fence ends at FENCE_ALT_MAX %.0f m.",
                above,
                most.get()));
    }

    private Optional<String> tooFar(int type, VehicleStatus status, Geodetic place) {
        Optional<Double> radius = values.of(RADIUS);
        boolean homeTold = status.homeLatitudeE7() != 0 || status.homeLongitudeE7() != 0;
        if ((type & BY_CIRCLE) == 0 || !homeTold || radius.isEmpty()) {
            return Optional.empty();
        }
        Geodetic home = new Geodetic(status.homeLatitudeE7() / E7, status.homeLongitudeE7() / E7);
        double meters = Geodesy.distanceMeters(home, place);
        return meters <= radius.get()
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "The place is %.0f m from its home, and its own fence ends at FENCE_RADIUS %.0f m.",
                        meters,
                        radius.get()));
    }

    private static @Nullable Double aboveHome(VehicleStatus status, Altitude altitude) {
        if (altitude.reference() == Altitude.Reference.HOME) {
            return altitude.meters();
        }
        Double home = status.homeAltitudeAmslMeters();
        return home == null ? null : Double.valueOf(altitude.meters() - home);
    }
}
