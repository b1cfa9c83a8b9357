package org.dronemap.core.zone;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.Function;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;

/** In-memory registry of the zones in force; each change takes effect at once. Any thread. */
public final class ZoneRegistry {
    private final CopyOnWriteArrayList<Consumer<Change>> listeners = new CopyOnWriteArrayList<>();
    private volatile List<Zone> zones = List.of();
    private volatile Function<DroneId, OrganisationId> owners = drone -> OrganisationId.HOME;

    /** Change of the zones: those put in (new or changed), and the former versions of those changed or removed. */
    public record Change(List<Zone> put, List<Zone> former) {}

    /** Who knows to whom drones belong; until it is said all belong to the default organisation. */
    public void ownersBy(Function<DroneId, OrganisationId> known) {
        owners = known;
    }

    public List<Zone> zones() {
        return zones;
    }

    /** Heard by whoever changes the book, on its thread; must return at once. */
    public void onChange(Consumer<Change> listener) {
        listeners.add(listener);
    }

    /** New ones, or new forms of old ones: all at once. */
    public void put(Collection<Zone> changed) {
        List<Zone> put = List.copyOf(changed);
        List<Zone> former;
        synchronized (this) {
            List<String> ids = put.stream().map(Zone::id).toList();
            former = zones.stream().filter(zone -> ids.contains(zone.id())).toList();
            List<Zone> next = new ArrayList<>(zones);
            next.removeIf(zone -> ids.contains(zone.id()));
            next.addAll(put);
            zones = List.copyOf(next);
        }
        listeners.forEach(listener -> listener.accept(new Change(put, former)));
    }

    public void remove(String id) {
        List<Zone> former;
        synchronized (this) {
            former = zones.stream().filter(zone -> zone.id().equals(id)).toList();
            zones = zones.stream().filter(zone -> !zone.id().equals(id)).toList();
        }
        listeners.forEach(listener -> listener.accept(new Change(List.of(), former)));
    }

    /** Those that bind a drone that this user flies at any time of a span. */
    public List<Zone> binding(String user, DroneId drone, Instant begin, Instant end) {
        OrganisationId owner = owners.apply(drone);
        return zones.stream()
                .filter(zone -> zone.isGlobal() || zone.organisation().equals(owner))
                .filter(zone ->
                        zone.binding().binds(user, drone) && zone.validity().between(begin, end))
                .toList();
    }
}
