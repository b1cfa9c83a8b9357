package org.dronemap.ws.wiring;

import java.io.IOException;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.plainhttp.PhoneTrustServer;
import org.dronemap.ws.settings.ServerSettings;
import org.jspecify.annotations.Nullable;

/** Starts the plain HTTP page from which phones get the certificate authority, if the settings ask for it. */
final class PhoneTrustStarter {
    private PhoneTrustStarter() {}

    static PhoneTrustServer.@Nullable Configuration of(ServerSettings settings) {
        ServerSettings.Tls tls = settings.tls();
        return tls == null || tls.authority() == null
                ? null
                : new PhoneTrustServer.Configuration(
                        settings.bindAddress(),
                        tls.phonePort(),
                        tls.authority(),
                        tls.certificate(),
                        settings.httpPort());
    }

    static PhoneTrustServer open(PhoneTrustServer.Configuration place) {
        try {
            return PhoneTrustServer.open(place);
        } catch (IOException e) {
            throw new SetupException(
                    "The page for phones cannot be opened on port " + place.port() + " (DRONEMAP_PHONE_PORT): "
                            + e.getMessage() + ".",
                    e);
        }
    }

    static @Nullable String url(PhoneTrustServer.@Nullable Configuration place) {
        try {
            return place == null ? null : place.url();
        } catch (IOException e) {
            throw new SetupException("DRONEMAP_TLS_AUTHORITY cannot be used: " + e.getMessage(), e);
        }
    }
}
