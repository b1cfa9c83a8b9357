package org.dronemap.core.safety;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Gps;
import org.dronemap.core.drone.GpsFix;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.jspecify.annotations.Nullable;

/** Chooses how a flying drone that nobody controls comes down: home, to a landing site, or where it is. Pure. */
public final class ReturnPlanner {
    /** Autopilots come with 15 to 60 m. */
    private static final double USUAL_RETURN_METERS = 30;
    /** With so little left it falls before anybody comes: no zone is worse than that. */
    private static final double LAST_SECONDS = 60;

    /** Check of a return, a way or a landing against the zones, with objections as sentences; empty: no objection. */
    public interface ZoneCheck {
        Optional<String> againstReturn();

        Optional<String> against(Command.GoTo way);

        Optional<String> againstLanding();
    }

    /**
     * Situation of a drone that has to return or land: its state, battery time, landing sites and failed options.
     *
     * @param secondsLeft what its battery lasts for; empty: not known
     * @param failed what was tried lately without success
     */
    public record Situation(
            DroneState drone, OptionalDouble secondsLeft, List<LandingSite> places, Set<ReturnOption> failed) {
        public Situation {
            places = List.copyOf(places);
            failed = Set.copyOf(failed);
        }
    }

    /**
     * Next step to return or land a drone, and the reasons why nothing better is possible.
     *
     * @param rung null: nothing can be done
     * @param command null: nothing can be done
     * @param place where it comes down; null: where it is, or at home, as {@code rung} says
     * @param why sentences; empty: it is the best way
     */
    public record PlannedReturn(
            @Nullable ReturnOption rung,
            @Nullable Command command,
            @Nullable LandingSite place,
            String why) {}

    private ReturnPlanner() {}

    public static PlannedReturn next(Situation plight, ZoneCheck zones) {
        List<String> why = new ArrayList<>();
        Optional<String> notHome = againstReturn(plight, zones);
        if (notHome.isEmpty()) {
            return new PlannedReturn(ReturnOption.RETURN, new Command.ReturnToLaunch(), null, "");
        }
        why.add(notHome.get());
        Optional<PlannedReturn> elsewhere = elsewhere(plight, zones, notHome.get());
        if (elsewhere.isPresent()) {
            return elsewhere.get();
        }
        Optional<String> notDown = againstLanding(plight, zones);
        if (notDown.isEmpty()) {
            return new PlannedReturn(ReturnOption.LAND, new Command.Land(), null, String.join(" ", why));
        }
        why.add(notDown.get());
        return new PlannedReturn(null, null, null, String.join(" ", why));
    }

    /** Whether its battery lasts only just for the way home, so that nobody is waited for any longer. */
    public static boolean hurries(DroneState drone, OptionalDouble secondsLeft, double seconds) {
        Home home = drone.home();
        if (home == null || secondsLeft.isEmpty()) {
            return false;
        }
        OptionalDouble needed = BatteryEndurance.secondsTo(drone, home.point(), returnMeters(drone));
        return needed.isPresent() && secondsLeft.getAsDouble() < needed.getAsDouble() + seconds;
    }

    private static Optional<String> againstReturn(Situation plight, ZoneCheck zones) {
        DroneState drone = plight.drone();
        if (!can(drone, Capability.RETURN_TO_LAUNCH)) {
            return Optional.of("It cannot return by itself.");
        }
        if (plight.failed().contains(ReturnOption.RETURN)) {
            return Optional.of("It did not return.");
        }
        Gps gps = drone.gps();
        if (gps != null && gps.fix() == GpsFix.NONE) {
            return Optional.of("It does not know where it is.");
        }
        Home home = drone.home();
        return (home == null ? Optional.<String>empty() : tooFar(plight, home.point(), "home"))
                .or(() -> zones.againstReturn().map(one -> "It does not return: " + one));
    }

    private static Optional<String> tooFar(Situation plight, Geodetic place, String words) {
        OptionalDouble left = plight.secondsLeft();
        OptionalDouble needed = BatteryEndurance.secondsTo(plight.drone(), place, returnMeters(plight.drone()));
        return left.isEmpty() || needed.isEmpty() || left.getAsDouble() >= needed.getAsDouble()
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "Its battery lasts for about %.0f s, and the way %s takes about %.0f s.",
                        left.getAsDouble(),
                        words,
                        needed.getAsDouble()));
    }

    private static Optional<PlannedReturn> elsewhere(Situation plight, ZoneCheck zones, String why) {
        DroneState drone = plight.drone();
        Geodetic here = point(drone);
        if (here == null
                || plight.failed().contains(ReturnOption.ELSEWHERE)
                || !can(drone, Capability.GO_TO)
                || !can(drone, Capability.LAND)) {
            return Optional.empty();
        }
        return plight.places().stream()
                .sorted(Comparator.comparingDouble(place -> Geodesy.distanceMeters(here, place.point())))
                .filter(place -> tooFar(plight, place.point(), "there").isEmpty())
                .flatMap(place -> way(drone, place).stream()
                        .filter(way -> zones.against(way).isEmpty())
                        .map(way -> new PlannedReturn(ReturnOption.ELSEWHERE, way, place, why)))
                .findFirst();
    }

    /** At the height that it has: nothing is known of what stands in the way lower down. */
    private static Optional<Command.GoTo> way(DroneState drone, LandingSite place) {
        Position position = drone.position();
        Double above = position == null ? null : position.altitudeAboveHomeMeters();
        return above == null
                ? Optional.empty()
                : Optional.of(new Command.GoTo(place.point(), Altitude.aboveHome(above)));
    }

    private static Optional<String> againstLanding(Situation plight, ZoneCheck zones) {
        DroneState drone = plight.drone();
        if (!can(drone, Capability.LAND)) {
            return Optional.of("It cannot land by itself.");
        }
        if (plight.failed().contains(ReturnOption.LAND)) {
            return Optional.of("It did not land.");
        }
        boolean falls = plight.secondsLeft().orElse(Double.POSITIVE_INFINITY) < LAST_SECONDS;
        return falls || point(drone) == null
                ? Optional.empty()
                : zones.againstLanding().map(one -> "It does not land here: " + one);
    }

    private static boolean can(DroneState drone, Capability capability) {
        return drone.capabilities().commands().contains(capability);
    }

    private static @Nullable Geodetic point(DroneState drone) {
        Position position = drone.position();
        return position == null ? null : position.point();
    }

    private static double returnMeters(DroneState drone) {
        ReturnHeight set = drone.returnHeight();
        return set == null ? USUAL_RETURN_METERS : set.meters();
    }
}
