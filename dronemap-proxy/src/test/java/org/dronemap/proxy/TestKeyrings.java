package org.dronemap.proxy;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.access.LinkSecurity;
import org.dronemap.core.access.LinkSecurityStore;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.time.RealTime;
import org.dronemap.proxy.signing.KeyringRegistry;

/** Keyrings over a store in memory. */
public final class TestKeyrings implements LinkSecurityStore {
    private final Map<DroneId, LinkSecurity> kept = new ConcurrentHashMap<>();

    /** For drones of a cloud. */
    public static KeyringRegistry of(CloudManager cloud, StoreWriter journal) {
        return new KeyringRegistry(
                new KeyringRegistry.Dependencies(
                        new TestKeyrings(),
                        journal,
                        drone -> cloud.drone(drone)
                                .map(state -> state.link().key().systemId())
                                .orElse(-1),
                        (drone, sentence) -> cloud.publishMessage(drone, Severity.WARNING, sentence)),
                new RealTime());
    }

    @Override
    public List<LinkSecurity> all() {
        return List.copyOf(kept.values());
    }

    @Override
    public void save(LinkSecurity security) {
        kept.put(security.drone(), security);
    }

    @Override
    public void saveStamp(DroneId drone, long stamp) {
        kept.computeIfPresent(
                drone,
                (id, security) -> new LinkSecurity(
                        id, security.policy(), security.key(), security.nextKey(), security.proven(), stamp));
    }
}
