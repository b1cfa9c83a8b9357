package org.dronemap.proxy.endpoint;

import java.util.function.Supplier;
import javax.net.ssl.SSLContext;
import org.dronemap.core.process.PeerCrashGuard;
import org.jspecify.annotations.Nullable;

/**
 * Protection that endpoints are opened with: DTLS keys, TLS certificate, WebSocket limits, and the guard that refuses
 * peers suspected of crashing the server.
 *
 * @param keys what vehicles prove themselves with on DTLS links
 * @param tls the server's certificate for {@code wssserver://}, asked for each new connection; null: it has none
 * @param limits of WebSockets that have not shaken hands
 * @param watch over whose bytes are being worked on
 */
public record EndpointSecurity(
        DtlsKeys keys,
        Supplier<@Nullable SSLContext> tls,
        BoundedWebSocketFactory.Limits limits,
        PeerCrashGuard watch) {
    /** Without a certificate. */
    public static EndpointSecurity of(DtlsKeys keys) {
        return new EndpointSecurity(keys, () -> null, BoundedWebSocketFactory.Limits.DEFAULT, PeerCrashGuard.NONE);
    }
}
