package org.dronemap.ws.recording;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;

/** Knows which organisation owns each replay of a recording and the drones that it shows. Any thread. */
public final class ReplayOwners {
    /** More than are kept to be looked at. */
    private static final int MOST = 1_000;
    /** Of a drone that is there before it is known who plays it. */
    private static final OrganisationId NOBODY = new OrganisationId("nobody");

    private final GrantRegistry book;

    /** Guarded by this. */
    private final Map<String, Played> played = new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Played> eldest) {
            return size() > MOST;
        }
    };

    private record Played(OrganisationId owner, List<DroneId> drones) {}

    private ReplayOwners(GrantRegistry book) {
        this.book = book;
    }

    /** Those of all recordings that {@code cloud} is shown from now on. */
    public static ReplayOwners of(GrantRegistry book, CloudManager cloud) {
        ReplayOwners owners = new ReplayOwners(book);
        cloud.registerBy((drone, session) -> {
            if (session.replay()) {
                // A recording is told from others by the port of its sessions.
                owners.appeared("r" + session.key().port(), drone);
            }
        });
        return owners;
    }

    /** A recording shows a drone, which nobody can see yet. */
    private synchronized void appeared(String replay, DroneId drone) {
        Played by = played.computeIfAbsent(replay, id -> new Played(NOBODY, new ArrayList<>()));
        by.drones().add(drone);
        book.lend(drone, by.owner());
    }

    synchronized void began(String replay, OrganisationId owner) {
        Played before = played.get(replay);
        Played now = new Played(owner, before == null ? new ArrayList<>() : before.drones());
        played.put(replay, now);
        now.drones().forEach(drone -> book.lend(drone, owner));
    }

    synchronized boolean isOf(String replay, OrganisationId organisation) {
        Played known = played.get(replay);
        return known != null && known.owner().equals(organisation);
    }
}
