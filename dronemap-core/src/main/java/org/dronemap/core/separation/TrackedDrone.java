package org.dronemap.core.separation;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/**
 * One drone as all others have to reckon with it: what it shows, what its operation means it to do, and who may move it.
 *
 * @param silence for how long nothing was heard; zero while its link is live
 * @param intent null: nobody here means it to do anything
 * @param operation the id of the operation that has it and planned it together with its other drones; null: none did
 * @param velocity over the ground, as its positions show it
 * @param pace as far as it was seen, or is told by its intent
 */
public record TrackedDrone(
        DroneState state,
        Duration silence,
        @Nullable FlightIntent intent,
        Handling handling,
        @Nullable String operation,
        GroundVelocity velocity,
        FlightPace pace) {
    private static final double STILL_SPEED = 0.7;
    private static final double STILL_CLIMB = 0.3;
    /** Below this over its home it lands, and is not stopped any more. */
    private static final double LOWEST_HOLD_METERS = 8;

    public DroneId id() {
        return state.id();
    }

    public String name() {
        return state.name();
    }

    /** Null: not known. */
    @Nullable
    public Geodetic point() {
        Position position = state.position();
        return position == null ? null : position.point();
    }

    /** By its height above home, which it flies by; the satellites' own height is metres off. Empty: not known. */
    public Optional<Double> amslMeters() {
        Position position = state.position();
        if (position == null) {
            return Optional.empty();
        }
        Double above = position.altitudeAboveHomeMeters();
        Home home = state.home();
        return above != null && home != null
                ? Optional.of(home.altitudeAmslMeters() + above)
                : Optional.ofNullable(position.altitudeAmslMeters());
    }

    /** Of its home; empty: not known. */
    Optional<Double> homeAmslMeters() {
        Home home = state.home();
        return home == null ? Optional.ofNullable(state.groundAmslMeters()) : Optional.of(home.altitudeAmslMeters());
    }

    /** Over the ground, m/s: as it says itself, else as its positions show it. */
    double speed() {
        Motion motion = state.motion();
        Double said = motion == null ? null : motion.groundSpeed();
        return said == null ? velocity.speed() : said;
    }

    /** It neither goes nor climbs nor sinks. */
    boolean isStill() {
        Motion motion = state.motion();
        Double climb = motion == null ? null : motion.climbRate();
        return speed() < STILL_SPEED && climb != null && Math.abs(climb) < STILL_CLIMB;
    }

    boolean isLost() {
        return state.link().state() == LinkState.LOST || state.link().state() == LinkState.ENDED;
    }

    boolean isLive() {
        return state.link().state() == LinkState.LIVE;
    }

    @Nullable
    Steering steering() {
        return state.capabilities().steering(state.mode()).orElse(null);
    }

    boolean isOnMission() {
        return steering() == Steering.MISSION;
    }

    /** It stands and goes where it is told to. */
    boolean waits() {
        Steering steering = steering();
        return steering != null && steering.acceptsCommands() && !isLed();
    }

    /** It climbs, or goes to a place, since its operation told it to: it is in no mission, and does not stand either. */
    boolean isLed() {
        boolean told = step() == FlightIntent.Step.GO
                || (step() == FlightIntent.Step.RISE && state.airborne() && !ahead().isEmpty());
        return told && handling == Handling.COMMANDED && steering() == Steering.ORDERS;
    }

    /** It is heard, and stands in the air. */
    public boolean isStandingLive() {
        return isLive() && state.airborne() && waits();
    }

    boolean comesDown() {
        Steering steering = steering();
        return steering != null && steering.isSafe();
    }

    FlightIntent.@Nullable Step step() {
        return intent == null ? null : intent.step();
    }

    /** A command of its operation is on its way to it. */
    boolean isCommanded() {
        return intent != null && intent.commanded();
    }

    /** It can stand in the air. */
    boolean hovers() {
        return state.identification().kind().hovers();
    }

    boolean canGoTo() {
        return state.capabilities().commands().contains(Capability.GO_TO);
    }

    /** On its way home by itself, and not about to touch the ground there. */
    boolean isHomeward() {
        Position position = state.position();
        Double above = position == null ? null : position.altitudeAboveHomeMeters();
        return comesDown()
                && state.capabilities().commands().contains(Capability.RETURN_TO_LAUNCH)
                && above != null
                && above > LOWEST_HOLD_METERS;
    }

    /** What it flies of its mission from now on; nothing where that is not known. */
    List<MissionItem> ahead() {
        if (intent != null && !intent.items().isEmpty()) {
            return intent.items();
        }
        MissionProgress mission = state.mission();
        List<MissionItem> items = mission.items();
        if (items == null || mission.complete()) {
            return List.of();
        }
        Integer current = mission.current();
        int passed = current != null
                ? current
                : mission.reached().stream().mapToInt(index -> index + 1).max().orElse(0);
        return items.subList(Math.max(0, Math.min(passed, items.size())), items.size());
    }
}
