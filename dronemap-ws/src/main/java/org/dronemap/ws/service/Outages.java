package org.dronemap.ws.service;

import java.util.Optional;

/** Tells what will pass by itself, such as a store that is away, from what is broken. Any thread. */
@FunctionalInterface
public interface Outages {
    /** Empty: it is broken. */
    Optional<Rejection> of(Throwable thrown);
}
