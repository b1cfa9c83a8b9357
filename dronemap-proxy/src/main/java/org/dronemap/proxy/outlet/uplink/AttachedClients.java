package org.dronemap.proxy.outlet.uplink;

import java.util.List;
import org.dronemap.proxy.outlet.client.OutletClient;

/** The clients that are attached to the outlet, and a way to run tasks on their thread. Any thread. */
public interface AttachedClients {
    List<OutletClient> clients();

    /** On the outlet's thread, soon. */
    void later(Runnable task);
}
