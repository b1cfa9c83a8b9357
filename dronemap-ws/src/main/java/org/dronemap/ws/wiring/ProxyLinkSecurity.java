package org.dronemap.ws.wiring;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.LinkPolicy;
import org.dronemap.core.drone.DroneId;
import org.dronemap.proxy.signing.ChangeKind;
import org.dronemap.proxy.signing.ChangeResult;
import org.dronemap.proxy.signing.FrameCounts;
import org.dronemap.proxy.signing.Keyrings;
import org.dronemap.proxy.signing.LinkSecurityStatus;
import org.dronemap.ws.service.LinkSecurityControl;
import org.dronemap.ws.service.LinkSecurityView;
import org.dronemap.ws.service.WireNames;
import org.jspecify.annotations.Nullable;

/** Link security as the links keep it. */
record ProxyLinkSecurity(Keyrings keyrings) implements LinkSecurityControl {

    @Override
    public LinkSecurityView view(DroneId drone) {
        LinkSecurityStatus status = keyrings.status(drone);
        FrameCounts counts = status.counts();
        return new LinkSecurityView(
                WireNames.camel(status.policy()),
                status.fingerprint() == null ? null : new LinkSecurityView.Key(status.fingerprint(), status.proven()),
                status.nextFingerprint(),
                status.change() == null ? null : WireNames.camel(status.change()),
                status.safeLink(),
                new LinkSecurityView.Messages(
                        counts.valid(),
                        counts.unsigned(),
                        counts.badSignature(),
                        counts.replayed(),
                        counts.tooOld(),
                        counts.tooManyStreams()));
    }

    @Override
    public Optional<String> policy(DroneId drone, LinkPolicy policy) {
        return why(keyrings.policy(drone, policy));
    }

    @Override
    public boolean put(DroneId drone, LinkKey key) {
        return keyrings.put(drone, key);
    }

    @Override
    public CompletableFuture<Optional<String>> change(
            DroneId drone, Change change, @Nullable LinkKey newKey, boolean confirmed) {
        ChangeKind kind = switch (change) {
            case INSTALL -> ChangeKind.INSTALL;
            case ROTATE -> ChangeKind.ROTATE;
            case REVOKE -> ChangeKind.REVOKE;
        };
        return keyrings.change(drone, kind, newKey, confirmed).thenApply(ProxyLinkSecurity::why);
    }

    @Override
    public void forget(DroneId drone) {
        keyrings.forget(drone);
    }

    private static Optional<String> why(ChangeResult result) {
        if (result instanceof ChangeResult.Failed failed) {
            return Optional.of(failed.why());
        }
        return result instanceof ChangeResult.Unknown unknown ? Optional.of(unknown.why()) : Optional.empty();
    }
}
