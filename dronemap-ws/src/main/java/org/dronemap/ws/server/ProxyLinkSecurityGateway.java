package org.dronemap.ws.server;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.LinkSigningPolicy;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.DroneId;
import org.dronemap.proxy.signing.KeyChangeFault;
import org.dronemap.proxy.signing.KeyChangeKind;
import org.dronemap.proxy.signing.KeyChangeResult;
import org.dronemap.proxy.signing.KeyringRegistry;
import org.dronemap.proxy.signing.LinkSecurityStatus;
import org.dronemap.proxy.signing.SignatureCounts;
import org.dronemap.ws.link.LinkSecurityGateway;
import org.dronemap.ws.link.LinkSecurityView;
import org.dronemap.ws.problem.CommandProblem;
import org.dronemap.ws.problem.LinkSecurityProblem;
import org.dronemap.ws.problem.ProblemCode;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Adapter that sets MAVLink signing of drones in the proxy's key registry for the services. */
record ProxyLinkSecurityGateway(KeyringRegistry keyrings) implements LinkSecurityGateway {

    @Override
    public LinkSecurityView view(DroneId drone) {
        LinkSecurityStatus status = keyrings.status(drone);
        SignatureCounts counts = status.counts();
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
    public Optional<Fault> policy(DroneId drone, LinkSigningPolicy policy) {
        return why(keyrings.policy(drone, policy));
    }

    @Override
    public boolean put(DroneId drone, LinkKey key) {
        return keyrings.put(drone, key);
    }

    @Override
    public CompletableFuture<Optional<Fault>> change(
            DroneId drone, Change change, @Nullable LinkKey newKey, boolean confirmed) {
        KeyChangeKind kind = switch (change) {
            case INSTALL -> KeyChangeKind.INSTALL;
            case ROTATE -> KeyChangeKind.ROTATE;
            case REVOKE -> KeyChangeKind.REVOKE;
        };
        return keyrings.change(drone, kind, newKey, confirmed).thenApply(ProxyLinkSecurityGateway::why);
    }

    @Override
    public void forget(DroneId drone) {
        keyrings.forget(drone);
    }

    private static Optional<Fault> why(KeyChangeResult result) {
        if (result instanceof KeyChangeResult.Failed failed) {
            return Optional.of(new Fault(code(failed.fault()), failed.why()));
        }
        return result instanceof KeyChangeResult.Unknown unknown
                ? Optional.of(new Fault(LinkSecurityProblem.KEY_IN_DOUBT, unknown.why()))
                : Optional.empty();
    }

    private static ProblemCode code(KeyChangeFault fault) {
        return switch (fault) {
            case CHANGING -> LinkSecurityProblem.KEY_CHANGING;
            case NO_KEY -> LinkSecurityProblem.NO_KEY;
            case NOT_PROVEN -> LinkSecurityProblem.KEY_NOT_PROVEN;
            case NO_LINK -> new CommandProblem(OutcomeCode.LINK_MISSING);
            case LINK_NOT_SAFE -> LinkSecurityProblem.LINK_NOT_SAFE;
            case NOT_DONE -> LinkSecurityProblem.KEY_NOT_CHANGED;
            case REFUSED -> LinkSecurityProblem.KEY_REFUSED;
        };
    }
}
