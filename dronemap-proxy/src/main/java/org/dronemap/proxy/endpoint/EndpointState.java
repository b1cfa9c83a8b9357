package org.dronemap.proxy.endpoint;

import org.jspecify.annotations.Nullable;

/** The state of an endpoint; {@code reason} is a sentence for people when it is not open. */
public record EndpointState(Phase phase, @Nullable String reason) {
    static final EndpointState OPEN = new EndpointState(Phase.OPEN, null);

    /** Open: vehicles can be heard. Connecting: dialling for the first time. Failed: it will be tried again. */
    public enum Phase {
        OPEN,
        CONNECTING,
        FAILED
    }
}
