package org.dronemap.core.drone;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.mission.MissionAbilities;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * Capabilities of one vehicle, as its autopilot adapter declares them: commands, flight modes, ways of steering.
 *
 * @param modes flight modes that can be set by name
 * @param steering what a vehicle goes by in a mode; of one that is not there nothing is known but that it flies by itself
 * @param usual of the modes in which a vehicle goes by something, the one that it is put into for that
 * @param arming for a mode in which the vehicle refuses to be armed, the mode that lets it
 * @param missions what it takes in missions
 * @param known false until the adapter declared it
 */
public record Capabilities(
        Set<Capability> commands,
        List<String> modes,
        Map<String, Steering> steering,
        Map<Steering, String> usual,
        Map<String, String> arming,
        MissionAbilities missions,
        boolean known) {
    public static final Capabilities NONE = new Capabilities(Set.of(), List.of());
    /** Of a vehicle that was not asked yet. */
    public static final Capabilities UNKNOWN =
            new Capabilities(Set.of(), List.of(), Map.of(), Map.of(), Map.of(), MissionAbilities.ALL, false);

    /** Control source of a vehicle in a flight mode, such as a pilot's sticks, commands or the mission on board. */
    @Stored(names = "STICKS ORDERS STANDS MISSION HOME SAFETY")
    public enum Steering {
        /** A pilot's sticks. */
        STICKS,
        /** Whoever gives orders or leads it; it waits for them. */
        ORDERS,
        /** Nobody: it stands still and waits for orders, but lets nobody lead it. */
        STANDS,
        /** The mission on board. */
        MISSION,
        /** Its own way home. */
        HOME,
        /** Its own way down. */
        SAFETY;

        /** Without anybody who steers, nothing goes on. */
        public boolean waitsForSomebody() {
            return this == STICKS || acceptsCommands();
        }

        /** It comes home or down by itself. */
        public boolean isSafe() {
            return this == HOME || this == SAFETY;
        }

        /** It goes where it is told to. */
        public boolean acceptsCommands() {
            return this == ORDERS || this == STANDS;
        }
    }

    public Capabilities {
        commands = Set.copyOf(commands);
        modes = List.copyOf(modes);
        steering = Map.copyOf(steering);
        usual = Map.copyOf(usual);
        arming = Map.copyOf(arming);
    }

    /** Of a vehicle that has one mode for each thing. */
    public Capabilities(Set<Capability> commands, List<String> modes, Map<String, Steering> steering) {
        this(commands, modes, steering, Map.of(), Map.of(), MissionAbilities.ALL, true);
    }

    /** Of a vehicle whose modes say nothing of what it goes by. */
    public Capabilities(Set<Capability> commands, List<String> modes) {
        this(commands, modes, Map.of());
    }

    /** What the vehicle goes by in that mode; empty: not known, or by itself. */
    public Optional<Steering> steering(@Nullable String mode) {
        return mode == null ? Optional.empty() : Optional.ofNullable(steering.get(mode));
    }

    /** The mode to change to before it can be armed; empty: it can be as it is, as far as is known. */
    public Optional<String> armingMode(@Nullable String mode) {
        return mode == null ? Optional.empty() : Optional.ofNullable(arming.get(mode));
    }

    /** What it can do, in modes that its adapter knows. */
    public static Capabilities of(
            Set<Capability> can,
            List<String> modes,
            Map<String, Steering> steering,
            Map<Steering, String> usual,
            Map<String, String> arming) {
        return new Capabilities(can, modes, steering, usual, arming, MissionAbilities.ALL, true);
    }

    /** The same of a vehicle that takes in missions what is said here. */
    public Capabilities with(MissionAbilities other) {
        return new Capabilities(commands, modes, steering, usual, arming, other, known);
    }

    /** The same of a vehicle that no mode keeps from being armed. */
    public static Capabilities of(
            Set<Capability> can, List<String> modes, Map<String, Steering> steering, Map<Steering, String> usual) {
        return of(can, modes, steering, usual, Map.of());
    }

    /** In that mode it comes home or down by itself. */
    public boolean isSafe(@Nullable String mode) {
        return steering(mode).filter(Steering::isSafe).isPresent();
    }

    /** The mode to put it into for that; empty when it has none. */
    public Optional<String> mode(Steering wanted) {
        return Optional.ofNullable(usual.get(wanted))
                .or(() -> modes.stream()
                        .filter(mode -> steering.get(mode) == wanted)
                        .findFirst());
    }
}
