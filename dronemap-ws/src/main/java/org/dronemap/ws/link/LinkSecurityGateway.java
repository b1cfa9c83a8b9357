package org.dronemap.ws.link;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.LinkSigningPolicy;
import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.problem.ProblemCode;
import org.jspecify.annotations.Nullable;

/**
 * Port through which the services set MAVLink signing (policy and keys) of a drone's links in the proxy. Any thread.
 */
public interface LinkSecurityGateway {
    /** Kinds of changes to the signing key on a vehicle: install, rotate or revoke. */
    enum Change {
        INSTALL,
        ROTATE,
        REVOKE
    }

    /** Reason why a change of link security failed: a sentence, and a problem code that refers to a drone. */
    record Fault(ProblemCode code, String sentence) {}

    LinkSecurityView view(DroneId drone);

    /** Why the policy cannot be that now; empty: it is, durably. */
    Optional<Fault> policy(DroneId drone, LinkSigningPolicy policy);

    /** Keeps a key that the vehicle does not have yet; false when it uses one already. */
    boolean put(DroneId drone, LinkKey key);

    /**
     * Changes the key on the vehicle; ends with why that did not come about, or empty.
     *
     * @param newKey for a rotation
     * @param confirmed the asker vouches that nobody listens on the link
     */
    CompletableFuture<Optional<Fault>> change(
            DroneId drone, Change change, @Nullable LinkKey newKey, boolean confirmed);

    /** Forgets the key here; the vehicle keeps it. */
    void forget(DroneId drone);
}
