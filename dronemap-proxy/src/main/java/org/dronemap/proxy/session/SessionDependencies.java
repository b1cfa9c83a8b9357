package org.dronemap.proxy.session;

import java.util.function.LongSupplier;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.process.PeerCrashGuard;
import org.dronemap.proxy.signing.KeyringRegistry;

/** The services and settings that every MAVLink vehicle session depends on. */
public record SessionDependencies(
        CloudManager cloud,
        Lanes lanes,
        LongSupplier nanoTime,
        KeyringRegistry keyrings,
        FrameTap.Factory taps,
        Enrolment enrolment,
        IdentificationRateLimiter asks,
        PeerCrashGuard watch) {
    long now() {
        return nanoTime.getAsLong();
    }
}
