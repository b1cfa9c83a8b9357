package org.dronemap.ws.limit;

import org.apache.coyote.http11.Http11NioProtocol;

/** Tomcat's HTTP/1.1 protocol on a {@link BoundedNioEndpoint}; Tomcat creates it by its class name. */
public final class BoundedHttpProtocol extends Http11NioProtocol {
    private final BoundedNioEndpoint door;

    public BoundedHttpProtocol() {
        this(new BoundedNioEndpoint());
    }

    private BoundedHttpProtocol(BoundedNioEndpoint door) {
        super(door);
        this.door = door;
    }

    public void limits(ClientLimits limits) {
        door.limits(limits);
    }

    /** Clients that took too long for the head of a request. */
    public long cutCount() {
        return door.cutCount();
    }

    /** Connections beyond what a host may have. */
    public long turnedAwayCount() {
        return door.turnedAwayCount();
    }
}
