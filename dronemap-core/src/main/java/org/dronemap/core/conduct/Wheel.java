package org.dronemap.core.conduct;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.Holder;
import org.dronemap.core.operation.Guide;
import org.dronemap.core.operation.Reach;
import org.dronemap.core.operation.Scene;
import org.dronemap.core.operation.Sighting;
import org.dronemap.core.operation.Surroundings;
import org.jspecify.annotations.Nullable;

/** Hands what the guide of one operation says to the gate for setpoints. Owned by the conductor's thread, but for {@link #sighted} and {@link #newest}. */
final class Wheel<S> {
    /** Between two turns of the conductor some few come, or what a phone kept while it was cut off. */
    private static final int MOST_WAITING = 128;

    private static final Duration LATELY = Duration.ofSeconds(5);

    private final DroneCrew crew;
    private final Holder.Operation holder;
    private final Guide<S> guide;
    private final Queue<Sighting> sightings = new ArrayDeque<>();
    private final Map<DroneId, String> refusals = new HashMap<>();
    private Set<DroneId> steered = Set.of();
    private @Nullable Instant heard;
    /** When the newest came that was of no use. */
    private @Nullable Instant vaguely;

    private volatile @Nullable Reach reach;
    // This and what waits are guarded by what waits.
    private @Nullable Sighting newest;

    Wheel(DroneCrew crew, Holder.Operation holder, Guide<S> guide) {
        this.crew = crew;
        this.holder = holder;
        this.guide = guide;
    }

    /** Any thread. */
    Reception sighted(Sighting sighting) {
        synchronized (sightings) {
            Sighting before = newest;
            if (before != null && sighting.number() <= before.number()) {
                return Reception.KNOWN;
            }
            if (sightings.size() >= MOST_WAITING) {
                return Reception.CROWDED;
            }
            sightings.add(sighting);
            newest = sighting;
            return Reception.TAKEN;
        }
    }

    /** The newest that was taken since the process began; null: none was. Any thread. */
    @Nullable
    Sighting newest() {
        synchronized (sightings) {
            return newest;
        }
    }

    /** How whoever tells of sightings is reached from now on. Any thread. */
    void reached(Reach how) {
        reach = how;
    }

    /** Null: not known. Any thread. */
    @Nullable
    Reach reach() {
        return reach;
    }

    private List<Sighting> taken() {
        synchronized (sightings) {
            List<Sighting> all = List.copyOf(sightings);
            sightings.clear();
            return all;
        }
    }

    /** Tells the guide what came in, and the gate what the guide says; the scene with what became of it. */
    Scene turn(S state, Scene scene) {
        for (Sighting one : taken()) {
            boolean useful = guide.sighted(one);
            // What was kept while nobody could be told shows where it was, and not that it still says so.
            if (one.isFresh() && !useful) {
                vaguely = one.heard();
            } else if (one.isFresh() && (heard == null || one.heard().isAfter(heard))) {
                heard = one.heard();
            }
        }
        Reach how = reach(scene.now());
        Scene now = new Scene(scene.now(), scene.drones(), heard, how, scene.around(), Map.of());
        Map<DroneId, Setpoint> said = guide.steer(state, now);
        refusals.clear();
        said.forEach(
                (drone, setpoint) -> crew.steer(holder, drone, setpoint).ifPresent(why -> refusals.put(drone, why)));
        letGo(said.keySet());
        return new Scene(scene.now(), scene.drones(), heard, how, Surroundings.NONE, refusals);
    }

    private @Nullable Reach reach(Instant now) {
        Reach connection = reach;
        boolean speaks = connection == null || connection == Reach.SPEAKS;
        boolean vague =
                vaguely != null && vaguely.plus(LATELY).isAfter(now) && (heard == null || vaguely.isAfter(heard));
        return speaks && vague ? Reach.VAGUE : connection;
    }

    /** Of all others at once: they stand still. */
    void letGo(Set<DroneId> but) {
        Set<DroneId> others = new HashSet<>(steered);
        others.removeAll(but);
        steered = Set.copyOf(but);
        others.forEach(drone -> crew.letGo(holder, drone));
    }
}
