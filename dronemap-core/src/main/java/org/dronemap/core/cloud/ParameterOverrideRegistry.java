package org.dronemap.core.cloud;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.ParameterOverrideStore;
import org.dronemap.core.drone.ParameterOverrides;

/**
 * Owners' vehicle parameters that the cloud has overridden for loss of the cloud; in memory and stored. Any thread;
 * each drone's belongs to its lane.
 */
final class ParameterOverrideRegistry {
    private final ParameterOverrideStore store;
    private final StoreWriter journal;
    private final int afterSeconds;
    private final ReturnHeightAllocator heights;
    private final ConcurrentHashMap<DroneId, ParameterOverrides> kept = new ConcurrentHashMap<>();

    ParameterOverrideRegistry(
            ParameterOverrideStore store, StoreWriter journal, int afterSeconds, ReturnHeightAllocator heights) {
        this.store = store;
        this.journal = journal;
        this.afterSeconds = afterSeconds;
        this.heights = heights;
        store.all().forEach(values -> {
            kept.put(values.drone(), values);
            if (values.returnMeters() != null) {
                heights.reserve(values.drone(), values.returnMeters());
            }
        });
    }

    int afterSeconds() {
        return afterSeconds;
    }

    ReturnHeightAllocator heights() {
        return heights;
    }

    Optional<ParameterOverrides> kept(DroneId drone) {
        return Optional.ofNullable(kept.get(drone));
    }

    List<ParameterOverrides> all() {
        return List.copyOf(kept.values());
    }

    /** Ends when it is durable, and at hand. */
    CompletableFuture<Void> keep(ParameterOverrides values) {
        return journal.written("what the owner of " + values.droneName() + " had set", () -> {
            store.save(values);
            kept.put(values.drone(), values);
        });
    }

    /** It was set to fly home at another height than the cloud had chosen, in m above home. */
    void returnsAt(DroneId drone, double meters) {
        ParameterOverrides before = kept.get(drone);
        heights.reserve(drone, meters);
        if (before != null) {
            ParameterOverrides now = before.returningAt(meters);
            kept.put(drone, now);
            journal.write("how high " + now.droneName() + " flies home", () -> store.save(now), () -> {});
        }
    }

    /** The cloud's values are on board, or are not for certain any more. */
    void written(ParameterOverrides values, boolean written) {
        ParameterOverrides now = values.asWritten(written);
        kept.put(now.drone(), now);
        journal.write("what was set on " + now.droneName(), () -> store.save(now), () -> {});
    }

    /** It is put back. Where that cannot be written down, it is done once more after a restart, which changes nothing. */
    void done(DroneId drone) {
        kept.remove(drone);
        heights.release(drone);
        journal.write("that what the owner of " + drone + " had set is put back", () -> store.delete(drone), () -> {});
    }
}
