package org.dronemap.ws.testserver;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.LinkSigningPolicy;
import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.link.LinkSecurityGateway;
import org.dronemap.ws.link.LinkSecurityView;
import org.dronemap.ws.problem.LinkSecurityProblem;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Link security that takes every key, and lets no change succeed that nobody vouched for. */
final class FakeLinkSecurityGateway implements LinkSecurityGateway {
    private final Map<DroneId, LinkKey> keys = new ConcurrentHashMap<>();
    private final Map<DroneId, LinkSigningPolicy> policies = new ConcurrentHashMap<>();

    @Override
    public LinkSecurityView view(DroneId drone) {
        LinkKey key = keys.get(drone);
        return new LinkSecurityView(
                WireNames.camel(policies.getOrDefault(drone, LinkSigningPolicy.OFF)),
                key == null ? null : new LinkSecurityView.Key(key.fingerprint(), false),
                null,
                null,
                false,
                new LinkSecurityView.Messages(1, 2, 3, 4, 5, 6));
    }

    @Override
    public Optional<Fault> policy(DroneId drone, LinkSigningPolicy policy) {
        policies.put(drone, policy);
        return Optional.empty();
    }

    @Override
    public boolean put(DroneId drone, LinkKey key) {
        return keys.putIfAbsent(drone, key) == null;
    }

    @Override
    public CompletableFuture<Optional<Fault>> change(
            DroneId drone, Change change, @Nullable LinkKey newKey, boolean confirmed) {
        if (!confirmed) {
            return CompletableFuture.completedFuture(
                    Optional.of(new Fault(LinkSecurityProblem.LINK_NOT_SAFE, "The link could be listened to.")));
        }
        if (newKey != null) {
            keys.put(drone, newKey);
        }
        return CompletableFuture.completedFuture(Optional.empty());
    }

    @Override
    public void forget(DroneId drone) {
        keys.remove(drone);
    }
}
