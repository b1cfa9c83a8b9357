package org.dronemap.proxy.session;

import java.util.function.LongSupplier;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.Lanes;
import org.dronemap.core.process.PeerWatch;
import org.dronemap.proxy.signing.Keyrings;

/** The services and settings that every session depends on. */
public record Surroundings(
        CloudManager cloud,
        Lanes lanes,
        LongSupplier nanoTime,
        Keyrings keyrings,
        FrameTap.Factory taps,
        Enrolment enrolment,
        AskAllowance asks,
        PeerWatch watch) {
    long now() {
        return nanoTime.getAsLong();
    }
}
