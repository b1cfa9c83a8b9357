package org.dronemap.proxy.session;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.cloud.DroneLink;
import org.dronemap.core.event.DroneEvent;

/** Buffers the events of a vehicle that arrive before its session is bound to a drone. Owned by the session's lane. */
final class EarlyEvents {
    private static final int MOST_TEXTS = 20;

    private final Map<DroneEvent.Kind, DroneEvent> facts = new LinkedHashMap<>();
    private final List<DroneEvent> texts = new ArrayList<>();

    /** Keeps the newest of each fact, and the first sentences as long as no drone has heard them. */
    void add(DroneEvent event, boolean told) {
        switch (event.kind().early()) {
            case NEWEST -> facts.put(event.kind(), event);
            case FIRST -> {
                if (!told && texts.size() < MOST_TEXTS) {
                    texts.add(event);
                }
            }
            case NOT -> {}
        }
    }

    void publishTo(DroneLink link) {
        facts.values().forEach(link::accept);
        texts.forEach(link::accept);
        texts.clear();
    }
}
