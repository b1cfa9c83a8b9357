package org.dronemap.proxy.session;

import java.util.function.LongSupplier;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.Lanes;
import org.dronemap.proxy.signing.Keyrings;

/**
 * What every session needs: the cloud, its lanes, monotonic time in ns, keys of vehicles, who hears its frames, and how
 * strangers are treated.
 */
public record Surroundings(
        CloudManager cloud,
        Lanes lanes,
        LongSupplier nanoTime,
        Keyrings keyrings,
        FrameTap.Factory taps,
        Enrolment enrolment,
        AskAllowance asks) {
    long now() {
        return nanoTime.getAsLong();
    }
}
