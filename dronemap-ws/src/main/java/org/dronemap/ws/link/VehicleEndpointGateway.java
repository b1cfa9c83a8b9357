package org.dronemap.ws.link;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** Port through which the services manage the proxy's endpoints for vehicles, and read their traffic. Any thread. */
public interface VehicleEndpointGateway {
    /** One endpoint now. */
    record Status(
            String id,
            String url,
            String transport,
            String state,
            @Nullable String reason,
            EndpointView.Counts counts,
            List<EndpointView.PeerView> peers) {}

    List<Status> all();

    /**
     * The URL as it is kept.
     *
     * @throws IllegalArgumentException with a sentence that says what is wrong with it
     */
    String checked(String url);

    /**
     * Opens an endpoint, and tries again when it cannot.
     *
     * @throws IllegalStateException with a sentence when there is no room, or it is there already
     */
    void keep(String id, String url);

    /** False when there is none. */
    boolean remove(String id);

    /** Ends every link that was proven with that identity. */
    void disconnect(String identity);

    /** Of every vehicle. */
    List<LinkTrafficView> traffic();

    /** How many messages of robots were not taken, by why. */
    Map<String, Long> refusedMessages();
}
