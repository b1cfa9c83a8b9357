package org.dronemap.proxy.endpoint;

import java.util.Optional;

/**
 * Looks up the pre-shared key by which a vehicle (or an outlet's ground station) authenticates on DTLS endpoints. Any
 * thread; answers at once.
 */
@FunctionalInterface
public interface DtlsKeys {
    /** The secret of that identity; empty when there is none, or it was revoked. */
    Optional<byte[]> secret(String identity);

    /** Knows nobody. */
    static DtlsKeys none() {
        return identity -> Optional.empty();
    }
}
