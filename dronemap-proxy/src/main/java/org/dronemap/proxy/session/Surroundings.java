package org.dronemap.proxy.session;

import java.util.function.LongSupplier;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.Lanes;
import org.dronemap.core.process.PeerWatch;
import org.dronemap.proxy.signing.Keyrings;

/**
 * What every session needs: the cloud, its lanes, monotonic time in ns, keys of vehicles, who hears its frames, how
 * strangers are treated, and who wants to know whose bytes are worked on.
 */
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
