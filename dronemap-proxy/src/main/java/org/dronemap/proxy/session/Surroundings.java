package org.dronemap.proxy.session;

import java.util.function.LongSupplier;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.Lanes;

/** What every session needs: the cloud, its lanes, and monotonic time in ns. */
public record Surroundings(CloudManager cloud, Lanes lanes, LongSupplier nanoTime) {
    long now() {
        return nanoTime.getAsLong();
    }
}
