package org.dronemap.proxy.session;

import java.util.function.LongSupplier;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.Lanes;
import org.dronemap.proxy.signing.Keyrings;

/** What every session needs: the cloud, its lanes, monotonic time in ns, keys of vehicles, and who hears its frames. */
public record Surroundings(
        CloudManager cloud, Lanes lanes, LongSupplier nanoTime, Keyrings keyrings, FrameTap.Factory taps) {
    long now() {
        return nanoTime.getAsLong();
    }
}
