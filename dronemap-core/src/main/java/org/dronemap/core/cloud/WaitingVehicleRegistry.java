package org.dronemap.core.cloud;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.dronemap.core.drone.DroneKey;

/**
 * In-memory registry of vehicles that are connected and wait to be admitted. Bounded in all and for each address, so
 * that a flood of one cannot keep others out; who falls silent loses the place. Thread-safe.
 */
final class WaitingVehicleRegistry {
    private static final int PLACES = 500;
    private static final int PLACES_OF_ONE_ADDRESS = 20;
    private static final Duration SILENCE = Duration.ofSeconds(60);

    private final Clock clock;
    private final Map<DroneKey, WaitingVehicle> places = new LinkedHashMap<>();
    private final AtomicLong numbers = new AtomicLong();
    private long turnedAway;

    WaitingVehicleRegistry(Clock clock) {
        this.clock = clock;
    }

    /** Notes that it still waits; true when it has just come in, false also when there is no place for it. */
    synchronized boolean note(Claim claim, ClaimDecision.Quarantined verdict) {
        DroneKey key = claim.session().key();
        WaitingVehicle before = places.get(key);
        Instant now = clock.instant();
        if (before == null && isFullFor(key)) {
            turnedAway++;
            return false;
        }
        boolean isNew = before == null || !Objects.equals(before.claims(), verdict.claims());
        places.put(
                key,
                new WaitingVehicle(
                        before == null ? "w" + numbers.incrementAndGet() : before.id(),
                        key,
                        claim.session().transport(),
                        claim.identification(),
                        verdict.claims(),
                        verdict.why(),
                        before == null ? now : before.since(),
                        now));
        return isNew;
    }

    private boolean isFullFor(DroneKey key) {
        forgetTheSilent();
        long neighbours = places.keySet().stream()
                .filter(other -> other.address().equals(key.address()))
                .count();
        return places.size() >= PLACES || neighbours >= PLACES_OF_ONE_ADDRESS;
    }

    private void forgetTheSilent() {
        Instant oldest = clock.instant().minus(SILENCE);
        places.values().removeIf(waiting -> waiting.lastHeard().isBefore(oldest));
    }

    synchronized Optional<WaitingVehicle> find(DroneKey key) {
        return Optional.ofNullable(places.get(key));
    }

    synchronized void leave(DroneKey key) {
        places.remove(key);
    }

    /** Takes one out by its id. */
    synchronized Optional<WaitingVehicle> remove(String id) {
        Optional<WaitingVehicle> found =
                all().stream().filter(waiting -> waiting.id().equals(id)).findFirst();
        found.ifPresent(waiting -> places.remove(waiting.key()));
        return found;
    }

    /** Who waits, longest first. */
    synchronized List<WaitingVehicle> all() {
        forgetTheSilent();
        return places.values().stream()
                .sorted(Comparator.comparing(WaitingVehicle::since))
                .toList();
    }

    /** Claims that found no place. */
    synchronized long turnedAway() {
        return turnedAway;
    }
}
