package org.dronemap.ws.wiring;

import java.io.IOException;
import org.dronemap.ws.door.PhoneDoor;
import org.dronemap.ws.setting.SetupException;
import org.dronemap.ws.settings.Settings;
import org.jspecify.annotations.Nullable;

/** Opens the trust page for phones where the settings ask for it. */
final class PhoneDoors {
    private PhoneDoors() {}

    static PhoneDoor.@Nullable Place of(Settings settings) {
        Settings.Tls tls = settings.tls();
        return tls == null || tls.authority() == null
                ? null
                : new PhoneDoor.Place(
                        settings.bindAddress(),
                        tls.phonePort(),
                        tls.authority(),
                        tls.certificate(),
                        settings.httpPort());
    }

    static PhoneDoor open(PhoneDoor.Place place) {
        try {
            return PhoneDoor.open(place);
        } catch (IOException e) {
            throw new SetupException(
                    "The page for phones cannot be opened on port " + place.port() + " (DRONEMAP_PHONE_PORT): "
                            + e.getMessage() + ".",
                    e);
        }
    }

    static @Nullable String url(PhoneDoor.@Nullable Place place) {
        try {
            return place == null ? null : place.url();
        } catch (IOException e) {
            throw new SetupException("DRONEMAP_TLS_AUTHORITY cannot be used: " + e.getMessage(), e);
        }
    }
}
