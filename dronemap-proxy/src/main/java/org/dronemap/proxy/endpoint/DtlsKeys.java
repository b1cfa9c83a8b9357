package org.dronemap.proxy.endpoint;

import java.util.Optional;

/** The secrets that vehicles prove themselves with on an authenticated link. Any thread; answers at once. */
@FunctionalInterface
public interface DtlsKeys {
    /** The secret of that identity; empty when there is none, or it was revoked. */
    Optional<byte[]> secret(String identity);

    /** Knows nobody. */
    static DtlsKeys none() {
        return identity -> Optional.empty();
    }
}
