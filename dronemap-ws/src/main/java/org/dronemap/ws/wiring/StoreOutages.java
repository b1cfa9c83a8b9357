package org.dronemap.ws.wiring;

import java.util.Optional;
import org.dronemap.store.StoreException;
import org.dronemap.ws.service.Outages;
import org.dronemap.ws.service.Rejection;
import org.dronemap.ws.service.RejectionKind;

/** A store that is away or full is nobody's mistake; what it says itself is for those who run the server. */
final class StoreOutages implements Outages {
    @Override
    public Optional<Rejection> of(Throwable thrown) {
        for (Throwable cause = thrown; cause != null; cause = cause.getCause()) {
            if (cause instanceof StoreException store && store.isPassing()) {
                return Optional.of(new Rejection(
                        RejectionKind.UNAVAILABLE,
                        "What the server keeps cannot be reached or written at the moment; drones fly on. Try again"
                                + " later."));
            }
        }
        return Optional.empty();
    }
}
