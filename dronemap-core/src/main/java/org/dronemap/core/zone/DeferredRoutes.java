package org.dronemap.core.zone;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.SetRallyPoints;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.RallyPoint;
import org.jspecify.annotations.Nullable;

/**
 * Routes that a command would make its drone fly later by itself, such as to a new home; checked against flight bounds.
 *
 * @param why what speaks against it as such; null: it depends on the refuges
 * @param refuges where it would go once it is called home
 */
record DeferredRoutes(@Nullable RouteObjection why, PredictedRoute refuges) {
    private static final DeferredRoutes NONE = new DeferredRoutes(null, PredictedRoute.NONE);

    /** {@code words}: what the bounds are called. */
    static DeferredRoutes of(List<FlightBounds> bounds, String words, DroneState drone, Command command) {
        return switch (command.kind().laterChange()) {
            case NOTHING -> NONE;
            case PARAMETERS ->
                forbidden("Parameters say where a drone flies by itself, such as how high it comes home; within "
                        + words + " they cannot be written.");
            case HOME ->
                bounds.stream().anyMatch(DeferredRoutes::isMeasuredFromHome)
                        ? forbidden("The heights of " + words + " are measured from home; so home cannot be moved.")
                        : home(((Command.SetHome) command).point());
            case RALLY_POINTS -> rally(((SetRallyPoints) command).points());
            case MODE -> inMode(words, drone, ((Command.SetMode) command).mode());
        };
    }

    private static DeferredRoutes forbidden(String why) {
        return new DeferredRoutes(RouteObjection.forbidden(why), PredictedRoute.NONE);
    }

    private static DeferredRoutes inMode(String words, DroneState drone, String mode) {
        return fliesItsOwnWay(drone, mode)
                ? new DeferredRoutes(
                        RouteObjection.notCheckable("Where it flies in " + mode
                                + " is not known; so it cannot be checked against " + words + "."),
                        PredictedRoute.NONE)
                : NONE;
    }

    private static DeferredRoutes home(@Nullable Geodetic point) {
        return point == null ? NONE : to(List.of(refuge("The new home", point)));
    }

    private static DeferredRoutes rally(List<RallyPoint> points) {
        return to(IntStream.range(0, points.size())
                .mapToObj(index ->
                        refuge("Rally point " + (index + 1), points.get(index).point()))
                .toList());
    }

    private static DeferredRoutes to(List<Leg> refuges) {
        return new DeferredRoutes(null, new PredictedRoute(refuges, null));
    }

    private static Leg refuge(String words, Geodetic point) {
        return new Leg(words, point, point, new LegHeights(List.of(), true));
    }

    /**
     * The same of zones: a home that goes up or down takes along what the vehicle was told above it. What is told after that is
     * judged from the ground that it left; what it was told before is not judged again.
     */
    static Optional<RouteObjection> whyNot(List<Zone> zones, DroneState drone, Command command) {
        if (!(command instanceof Command.SetHome home) || isLevel(home, drone)) {
            return Optional.empty();
        }
        return zones.stream()
                .filter(zone -> isMeasuredFromHome(zone.band()))
                .findFirst()
                .map(zone -> RouteObjection.forbidden("The heights of " + zone.words()
                        + " are measured from where it took off; so its home can be moved at that height only."));
    }

    private static boolean isLevel(Command.SetHome home, DroneState drone) {
        HeightReferences levels = HeightReferences.of(drone);
        Position position = drone.position();
        Altitude wanted = home.altitude();
        Double amsl =
                wanted == null ? position == null ? null : position.altitudeAmslMeters() : levels.amslMeters(wanted);
        return amsl != null && levels.isZero(amsl);
    }

    private static boolean isMeasuredFromHome(FlightBounds bounds) {
        return isMeasuredFromHome(bounds.band());
    }

    private static boolean isMeasuredFromHome(AltitudeBand band) {
        return band.isBounded() && band.reference() == Altitude.Reference.HOME;
    }

    /** One that the vehicle does not have is refused for that. */
    private static boolean fliesItsOwnWay(DroneState drone, String mode) {
        return drone.capabilities().modes().contains(mode)
                && drone.capabilities().steering(mode).isEmpty();
    }
}
