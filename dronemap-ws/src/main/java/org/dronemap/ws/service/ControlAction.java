package org.dronemap.ws.service;

import java.util.Arrays;
import java.util.Optional;

/** What can be done about the control of a drone. */
public enum ControlAction {
    TAKE,
    REQUEST,
    GRANT,
    REFUSE,
    HAND_OVER,
    TAKE_OVER,
    HEARTBEAT,
    RELEASE;

    /** By its name on the wire, such as {@code handOver}. */
    public static Optional<ControlAction> named(String name) {
        return Arrays.stream(values())
                .filter(action -> WireNames.camel(action).equals(name))
                .findFirst();
    }
}
