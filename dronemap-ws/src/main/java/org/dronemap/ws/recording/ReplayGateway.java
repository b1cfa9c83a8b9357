package org.dronemap.ws.recording;

import java.io.InputStream;
import java.util.List;
import java.util.Optional;

/** Port through which the services have the proxy play recordings back as replay drones. */
public interface ReplayGateway {

    /**
     * Begins to play; takes the stream over and closes it.
     *
     * @throws IllegalStateException with a sentence when too many play already
     */
    ReplayView start(String name, InputStream recording, long lengthBytes, double speed);

    List<ReplayView> all();

    Optional<ReplayView> find(String id);

    /** Cancels one that plays, forgets one that has played; its drones go. False when there is none. */
    boolean remove(String id);
}
