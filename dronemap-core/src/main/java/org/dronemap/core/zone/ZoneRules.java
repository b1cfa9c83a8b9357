package org.dronemap.core.zone;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneState;

/** Rules by which zones forbid commands and setpoints that lead a drone into a breach, or cannot be checked. */
public final class ZoneRules {
    /** What comes into force while it flies counts already when it is sent off. */
    private static final Duration AHEAD = Duration.ofHours(1);

    private final ZoneRegistry book;

    public ZoneRules(ZoneRegistry book) {
        this.book = book;
    }

    /** Names the leg, the zone and a distance; empty when nothing speaks against it. */
    public Optional<RouteObjection> whyNot(String user, DroneState drone, Command command, Instant now) {
        List<Zone> zones = book.binding(user, drone.id(), now, now.plus(AHEAD));
        return zones.isEmpty()
                ? Optional.empty()
                : DeferredRoutes.whyNot(zones, drone, command)
                        .or(() -> whyNot(zones, drone, CommandRoutes.of(drone, command)));
    }

    /** The same for bounds that hold whoever commands this, all of them; {@code words} is what they are called. */
    public static Optional<RouteObjection> whyNot(
            List<FlightBounds> bounds, String words, DroneState drone, Command command) {
        if (bounds.isEmpty()) {
            return Optional.empty();
        }
        DeferredRoutes later = DeferredRoutes.of(bounds, words, drone, command);
        return Optional.ofNullable(later.why())
                .or(() -> whyNot(
                        CommandRoutes.of(drone, command),
                        drone,
                        check -> firstOf(bounds, one -> check.whyNot(one, words)),
                        words))
                .or(() -> whyNot(
                        later.refuges(),
                        drone,
                        check -> firstOf(bounds, one -> check.whyNot(one.atAnyHeight(), words)),
                        words));
    }

    /** What a return home would cross, for a warning: it is never forbidden. */
    public Optional<String> homewardDoubt(String user, DroneState drone, Instant now) {
        List<Zone> zones = book.binding(user, drone.id(), now, now);
        return zones.isEmpty() ? Optional.empty() : sentence(zones, drone, CommandRoutes.home(drone));
    }

    /** What a landing where it is would touch; nobody else but a rule asks before it lands a drone. */
    public Optional<String> landingDoubt(String user, DroneState drone, Instant now) {
        List<Zone> zones = book.binding(user, drone.id(), now, now);
        return zones.isEmpty() ? Optional.empty() : sentence(zones, drone, CommandRoutes.down(drone));
    }

    private static Optional<String> sentence(List<Zone> zones, DroneState drone, PredictedRoute route) {
        return whyNot(zones, drone, route).map(RouteObjection::sentence);
    }

    private static Optional<RouteObjection> whyNot(List<Zone> zones, DroneState drone, PredictedRoute route) {
        return whyNot(
                route,
                drone,
                check -> firstOf(zones, check::whyNot),
                "the zones that bind this flight, such as " + zones.get(0).words());
    }

    private static Optional<RouteObjection> whyNot(
            PredictedRoute route,
            DroneState drone,
            Function<LegCheck, Optional<RouteObjection>> judge,
            String against) {
        HeightReferences levels = HeightReferences.of(drone);
        Optional<RouteObjection> why = firstOf(route.legs(), leg -> judge.apply(new LegCheck(leg, levels)));
        String doubt = route.doubt();
        return why.isPresent() || doubt == null
                ? why
                : Optional.of(
                        RouteObjection.notCheckable(doubt + "; so the way cannot be checked against " + against + "."));
    }

    private static <T> Optional<RouteObjection> firstOf(List<T> all, Function<T, Optional<RouteObjection>> judge) {
        return all.stream().map(judge).flatMap(Optional::stream).findFirst();
    }
}
