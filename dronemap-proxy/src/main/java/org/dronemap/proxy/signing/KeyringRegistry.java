package org.dronemap.proxy.signing;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.BooleanSupplier;
import java.util.function.ToIntFunction;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.LinkSecurity;
import org.dronemap.core.access.LinkSecurityStore;
import org.dronemap.core.access.LinkSigningPolicy;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.time.Time;
import org.dronemap.mavlink.Frame;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The signing keyrings of all drones, and the operations of administrators on them. Any thread; changes wait for the
 * store.
 */
public final class KeyringRegistry implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(KeyringRegistry.class);

    private static final Duration LONGEST_WRITE = Duration.ofSeconds(10);

    private final Dependencies keeping;
    private final Time time;
    private final ConcurrentHashMap<DroneId, Keyring> rings = new ConcurrentHashMap<>();
    private final ConcurrentHashMap<DroneId, Set<LinkGuard>> links = new ConcurrentHashMap<>();

    /**
     * The store, journal and callbacks that keyrings depend on.
     *
     * @param systemIdOf the system id that a drone was last heard with
     * @param warn says a sentence to everybody who looks at the drone; does not wait
     */
    public record Dependencies(
            LinkSecurityStore store, StoreWriter journal, ToIntFunction<DroneId> systemIdOf, Announcer warn) {}

    /** Tells a sentence about a drone. */
    public interface Announcer {
        void warn(DroneId drone, String sentence);
    }

    public KeyringRegistry(Dependencies keeping, Time time) {
        this.keeping = keeping;
        this.time = time;
        keeping.store().all().forEach(security -> rings.put(security.drone(), ring(security)));
    }

    private Keyring ring(LinkSecurity security) {
        DroneId drone = security.drone();
        return new Keyring(
                security,
                keeping.systemIdOf().applyAsInt(drone),
                time.clock(),
                new Keyring.Callbacks(
                        (now, after) -> keeping.journal()
                                .write(
                                        "the link security of " + drone,
                                        () -> keeping.store().save(now),
                                        after),
                        now -> keeping.journal()
                                .write(
                                        "the signing time of " + drone,
                                        () -> keeping.store().saveStamp(drone, now.stamp()),
                                        () -> {}),
                        sentence -> warn(drone, sentence)),
                links(drone));
    }

    private void warn(DroneId drone, String sentence) {
        try {
            keeping.warn().warn(drone, sentence);
        } catch (RejectedExecutionException e) {
            LOG.warn("Nobody had room to hear of drone {}: {}", drone, sentence, e);
        }
    }

    /**
     * A guard for a new vehicle; {@code linkId}, 0 to 255, tells its kinds of links apart; {@code safe} says, on any thread,
     * whether anybody can listen now.
     */
    public LinkGuard guard(int linkId, BooleanSupplier safe) {
        return new LinkGuard(this, linkId, safe);
    }

    /** The links that are bound to a drone now; safe to change from any thread. */
    Set<LinkGuard> links(DroneId drone) {
        return links.computeIfAbsent(drone, id -> ConcurrentHashMap.newKeySet());
    }

    @Nullable
    Keyring find(DroneId drone) {
        return rings.get(drone);
    }

    @Nullable
    Keyring signerOf(Frame frame) {
        return rings.values().stream()
                .filter(ring -> ring.signed(frame))
                .findFirst()
                .orElse(null);
    }

    public LinkSecurityStatus status(DroneId drone) {
        Keyring ring = rings.get(drone);
        return ring == null
                ? new LinkSecurityStatus(LinkSigningPolicy.OFF, null, false, null, null, SignatureCounts.NONE, null)
                : ring.status();
    }

    /** Fails while the vehicle was never heard to sign, when it is to be required. */
    public synchronized KeyChangeResult policy(DroneId drone, LinkSigningPolicy policy) {
        Keyring ring = ring(drone);
        if (policy == LinkSigningPolicy.REQUIRED && !ring.security().proven()) {
            return new KeyChangeResult.Failed(
                    KeyChangeFault.NOT_PROVEN,
                    "The vehicle was never heard to sign with its key; install one first, or nothing"
                            + " that it says would be accepted.");
        }
        LinkSigningPolicy before = ring.security().policy();
        ring.setPolicy(policy);
        try {
            save(ring.security());
        } catch (CompletionException e) {
            ring.setPolicy(before);
            throw e;
        }
        return new KeyChangeResult.Done();
    }

    /** Returns when it is durable. Through the journal, since the drone itself may still be on its way there. */
    private void save(LinkSecurity security) {
        CompletableFuture<Void> kept = keeping.journal()
                .written(
                        "the link security of " + security.drone(),
                        () -> keeping.store().save(security));
        Void unused = time.join(kept, LONGEST_WRITE);
    }

    /** False when the vehicle uses a key already. The key is durable when this returns. */
    public synchronized boolean put(DroneId drone, LinkKey key) {
        Keyring ring = ring(drone);
        if (!ring.put(key)) {
            return false;
        }
        save(ring.security());
        return true;
    }

    /** Forgets the key here; the vehicle keeps it. */
    public synchronized void forget(DroneId drone) {
        Keyring ring = ring(drone);
        ring.clear();
        save(ring.security());
    }

    /** Begins a change on the vehicle; {@code newKey} is for a rotation. */
    public synchronized CompletableFuture<KeyChangeResult> change(
            DroneId drone, KeyChangeKind kind, @Nullable LinkKey newKey, boolean confirmed) {
        Keyring ring = ring(drone);
        KeyChangeResult.Failed obstacle = ring.obstacle(kind, confirmed);
        if (obstacle != null) {
            return CompletableFuture.completedFuture(obstacle);
        }
        if (newKey != null) {
            // Before the vehicle can have it: a key that only the vehicle knows would lock us out.
            LinkSecurity now = ring.security();
            save(new LinkSecurity(drone, now.policy(), now.key(), newKey, now.proven(), now.stamp()));
        }
        LOG.info("The link key of {} is being changed ({})", drone, kind);
        return ring.begin(kind, newKey, confirmed);
    }

    private Keyring ring(DroneId drone) {
        return rings.computeIfAbsent(drone, id -> ring(LinkSecurity.none(id)));
    }

    /** A drone was removed, and with it what was stored of it. */
    public void removed(DroneId drone) {
        rings.remove(drone);
        links.remove(drone);
    }

    /** Stores the time that signatures have reached. */
    @Override
    public void close() {
        for (Keyring ring : List.copyOf(rings.values())) {
            LinkSecurity security = ring.security();
            if (security.key() != null) {
                keeping.store().saveStamp(security.drone(), security.stamp());
            }
        }
    }
}
