package org.dronemap.proxy.endpoint;

import java.util.function.Supplier;
import javax.net.ssl.SSLContext;
import org.dronemap.core.process.PeerWatch;
import org.jspecify.annotations.Nullable;

/**
 * The keys, certificates and limits that endpoints for vehicles are secured with.
 *
 * @param keys what vehicles prove themselves with on DTLS links
 * @param tls the server's certificate for {@code wssserver://}, asked for each new connection; null: it has none
 * @param limits of WebSockets that have not shaken hands
 * @param watch over whose bytes are being worked on
 */
public record Doors(DtlsKeys keys, Supplier<@Nullable SSLContext> tls, WebSocketDoor.Limits limits, PeerWatch watch) {
    /** Without a certificate. */
    public static Doors of(DtlsKeys keys) {
        return new Doors(keys, () -> null, WebSocketDoor.Limits.DEFAULT, PeerWatch.NONE);
    }
}
