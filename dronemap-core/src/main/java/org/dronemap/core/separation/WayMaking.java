package org.dronemap.core.separation;

import java.util.Optional;

/** Has drones that stand in the way of another one step aside: two that wait for each other would stand for ever. */
final class WayMaking {
    private final SeparationRound round;

    WayMaking(SeparationRound round) {
        this.round = round;
    }

    /** {@code way}: what that drone flies as soon as it is clear. */
    void makeWay(TrackedDrone drone, Track way) {
        round.picture.drones().stream()
                .filter(other -> !other.id().equals(drone.id()) && mayBeMoved(drone, other))
                .filter(other ->
                        round.far(other).stream().anyMatch(track -> !way.isPassable(track, round.least(drone, other))))
                .findFirst()
                .ifPresent(other -> step(other, drone, way).ifPresent(step -> round.move(other, drone, step)));
    }

    /** It stands for us, nothing is under way to it, and of two that wait for each other it is the later one. */
    private boolean mayBeMoved(TrackedDrone drone, TrackedDrone other) {
        Yielding own = round.yielding(other);
        boolean later = own == null
                ? other.step() == FlightIntent.Step.STAND
                : !own.give().clear()
                        && !own.isBusy(round.picture.now())
                        && drone.id().value().compareTo(other.id().value()) < 0;
        return later
                && other.handling() == Handling.COMMANDED
                && other.isStandingLive()
                && other.hovers()
                && other.canGoTo()
                && !other.isCommanded();
    }

    private Optional<EvasiveMove> step(TrackedDrone other, TrackedDrone drone, Track way) {
        TrackSample here = round.far.here(other);
        if (here == null) {
            return Optional.empty();
        }
        Separation least = round.least(drone, other);
        // The way is flown once it is clear: then the other one stands aside already.
        return EvasiveMove.of(
                        other,
                        here,
                        round.far,
                        there -> round.mayGo(other, there),
                        track -> Math.min(
                                round.clearance(other, track, round::far),
                                track.last().clearance(way, least)))
                .filter(EvasiveMove::isClear);
    }
}
