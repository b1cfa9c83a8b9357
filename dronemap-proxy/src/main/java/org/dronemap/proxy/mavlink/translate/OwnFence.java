package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronemap.core.drone.OnboardFence;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.jspecify.annotations.Nullable;

/**
 * The fence that an ArduPilot vehicle keeps by itself, as far as it was read: heights, a circle around its home, areas.
 *
 * @param areas null where they were not read whole
 */
record OwnFence(Values values, @Nullable OnboardFence areas) {
    static final String ENABLE = "FENCE_ENABLE";
    static final String TYPE = "FENCE_TYPE";
    static final String RADIUS = "FENCE_RADIUS";
    static final String HIGHEST = "FENCE_ALT_MAX";
    static final String LOWEST = "FENCE_ALT_MIN";
    static final String TOTAL = "FENCE_TOTAL";
    static final String OPTIONS = "FENCE_OPTIONS";
    static final int BY_HEIGHT = 1;
    static final int BY_CIRCLE = 2;
    static final int BY_AREAS = 4;
    static final int BY_FLOOR = 8;
    private static final int ANY_AREA_WILL_DO = 2;
    private static final double E7 = 1e7;

    /** {@code value}: of the parameter with that name, where the vehicle has it. */
    interface Values {
        Optional<Double> of(String name);
    }

    /**
     * A place that the vehicle is to go to.
     *
     * @param words what the place is called at the beginning of a sentence
     * @param from where the way there begins; null: not known
     * @param aboveHome in metres; null: not known
     * @param onTheWay it comes up or goes down there, so that a floor does not bind
     */
    record Target(
            String words,
            @Nullable Geodetic from,
            @Nullable Geodetic point,
            @Nullable Double aboveHome,
            boolean onTheWay) {}

    boolean isOn() {
        return values.of(ENABLE).orElse(0.0) == 1;
    }

    private boolean has(int type) {
        return isOn() && (values.of(TYPE).map(Double::intValue).orElse(0) & type) != 0;
    }

    /** It has areas as far as it says: their type is on by default, also where there are none. */
    boolean mayHaveAreas() {
        return has(BY_AREAS) && values.of(TOTAL).orElse(1.0) > 0;
    }

    /** Areas that could not be compared with anything. */
    boolean hasUnreadAreas() {
        return mayHaveAreas() && (areas == null || !areas.leftOut().isEmpty());
    }

    /** Why the place, or the way there, is outside of it; empty: it is not, as far as is known. */
    Optional<String> against(VehicleStatus status, Target target) {
        return tooHigh(target)
                .or(() -> tooLow(target))
                .or(() -> tooFar(status, target))
                .or(() -> byAreas(target));
    }

    private Optional<String> tooHigh(Target target) {
        Double above = target.aboveHome();
        return Optional.ofNullable(has(BY_HEIGHT) ? above : null)
                .flatMap(meters -> values.of(HIGHEST)
                        .filter(most -> meters > most)
                        .map(most -> String.format(
                                Locale.ROOT,
                                "%s is %.0f m above its home, and its own fence ends at FENCE_ALT_MAX %.0f m.",
                                target.words(),
                                meters,
                                most)));
    }

    private Optional<String> tooLow(Target target) {
        Double above = target.aboveHome();
        return Optional.ofNullable(has(BY_FLOOR) && !target.onTheWay() ? above : null)
                .flatMap(meters -> values.of(LOWEST)
                        .filter(least -> meters < least)
                        .map(least -> String.format(
                                Locale.ROOT,
                                "%s is %.0f m above its home, and its own fence begins at FENCE_ALT_MIN %.0f m.",
                                target.words(),
                                meters,
                                least)));
    }

    private Optional<String> tooFar(VehicleStatus status, Target target) {
        boolean homeTold = status.homeLatitudeE7() != 0 || status.homeLongitudeE7() != 0;
        Geodetic point = target.point();
        if (!has(BY_CIRCLE) || !homeTold || point == null) {
            return Optional.empty();
        }
        double meters = Geodesy.distanceMeters(
                new Geodetic(status.homeLatitudeE7() / E7, status.homeLongitudeE7() / E7), point);
        return values.of(RADIUS)
                .filter(radius -> meters > radius)
                .map(radius -> String.format(
                        Locale.ROOT,
                        "%s is %.0f m from its home, and its own fence ends at FENCE_RADIUS %.0f m.",
                        target.words(),
                        meters,
                        radius));
    }

    private Optional<String> byAreas(Target target) {
        Geodetic point = target.point();
        if (!has(BY_AREAS) || areas == null || point == null) {
            return Optional.empty();
        }
        List<FenceArea> inside =
                areas.areas().stream().filter(FenceArea::inside).toList();
        boolean any =
                inside.size() > 1 && (values.of(OPTIONS).map(Double::intValue).orElse(0) & ANY_AREA_WILL_DO) != 0;
        if (any && inside.stream().noneMatch(area -> FenceAreaCheck.covers(area, point))) {
            return Optional.of(target.words() + " lies outside of all areas of its own fence.");
        }
        return areas.areas().stream()
                .filter(area -> !any || !area.inside())
                .flatMap(area -> FenceAreaCheck.against(area, target.from(), point).stream())
                .findFirst()
                .map(does -> target.words() + does);
    }
}
