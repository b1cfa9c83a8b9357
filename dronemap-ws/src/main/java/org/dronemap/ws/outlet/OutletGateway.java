package org.dronemap.ws.outlet;

import java.time.Duration;
import java.util.List;
import org.dronemap.core.access.LinkKey;

/** Port through which the services manage the proxy's outlet, where third-party ground stations attach. Any thread. */
public interface OutletGateway {
    /** Addresses that it listens on; empty: there is none. */
    List<String> endpoints();

    boolean hasKey(String user);

    /** Replaces the one before, durably, and ends its clients; false when somebody else uses that very key. */
    boolean putKey(String user, LinkKey key);

    /** Ends its clients; false when there was none. */
    boolean removeKey(String user);

    OutletView status();

    /** Looks at once what the users of all clients may do now, and returns when that holds. */
    void judgeAnew();

    /** Ends a client, which may come back in a minute; false when there is no such client. */
    boolean disconnect(String id);

    /**
     * Opens a port of the user's own, for a program that cannot sign and only looks.
     *
     * @param address from where it may be spoken to
     * @throws IllegalArgumentException with a sentence for what is no such address
     * @throws IllegalStateException with a sentence when there can be no more
     */
    OutletView.PortView openPort(String user, String address, Duration time);

    /** False when there is no such port. */
    boolean closePort(String id);

    void closePortsOf(String user);
}
