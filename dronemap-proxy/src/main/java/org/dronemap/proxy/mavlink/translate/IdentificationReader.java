package org.dronemap.proxy.mavlink.translate;

import java.util.Arrays;
import java.util.Locale;
import org.dronemap.core.drone.Identification;
import org.dronemap.mavlink.message.AutopilotVersion;
import org.jspecify.annotations.Nullable;

/** Derives a vehicle's identification (hardware id, firmware, kind) from its AUTOPILOT_VERSION and heartbeat. */
public final class IdentificationReader {
    private IdentificationReader() {}

    /** {@code version} is null until heard. */
    public static Identification of(AutopilotAdapter autopilot, int type, @Nullable AutopilotVersion version) {
        return new Identification(
                VehicleType.kind(type),
                autopilot.family(),
                autopilot.vehicle(),
                version == null ? null : firmware(version.flightSwVersion()),
                version == null ? null : hardwareUid(version));
    }

    /** Bytes from the top: major, minor, patch, kind of release. */
    private static @Nullable String firmware(long packed) {
        return packed == 0
                ? null
                : String.format(Locale.ROOT, "%d.%d.%d", packed >> 24 & 0xFF, packed >> 16 & 0xFF, packed >> 8 & 0xFF);
    }

    private static @Nullable String hardwareUid(AutopilotVersion version) {
        if (Arrays.stream(version.uid2()).anyMatch(part -> part != 0)) {
            StringBuilder hex = new StringBuilder();
            for (int part : version.uid2()) {
                hex.append(String.format(Locale.ROOT, "%02x", part));
            }
            return hex.toString();
        }
        return version.uid() == 0 ? null : Long.toHexString(version.uid());
    }
}
