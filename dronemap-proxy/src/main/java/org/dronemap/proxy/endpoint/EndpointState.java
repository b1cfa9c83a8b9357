package org.dronemap.proxy.endpoint;

import org.jspecify.annotations.Nullable;

/** State of an endpoint: open, or not open with the reason as a sentence for people. */
public record EndpointState(Phase phase, @Nullable String reason) {
    static final EndpointState OPEN = new EndpointState(Phase.OPEN, null);

    /** Open: vehicles can be heard. Connecting: dialling for the first time. Failed: it will be tried again. */
    public enum Phase {
        OPEN,
        CONNECTING,
        FAILED
    }
}
