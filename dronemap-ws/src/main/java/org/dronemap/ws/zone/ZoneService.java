package org.dronemap.ws.zone;

import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneBinding;
import org.dronemap.core.zone.ZoneRegistry;
import org.dronemap.core.zone.ZoneStore;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.problem.ValueProblem;

/**
 * Lets users list, add, import, change and delete zones of the cloud; each change is stored, then binds at once. Any
 * thread.
 */
public final class ZoneService {
    private static final int MOST = 500;

    private final Stores keeping;
    private final DroneService drones;
    private final Clock clock;

    /** Store of zones, registry of the zones in force, and the store of the users that zones may name. */
    public record Stores(ZoneStore store, ZoneRegistry book, AccessStore users) {}

    public ZoneService(Stores keeping, DroneService drones, Clock clock) {
        this.keeping = keeping;
        this.drones = drones;
        this.clock = clock;
    }

    public ZoneFeature.ZoneCollection zones(Principal principal) {
        return ZoneFeature.ZoneCollection.of(
                keeping.store().zones().stream()
                        .filter(zone -> isShownTo(principal, zone))
                        .toList(),
                principal.organisation());
    }

    public ZoneFeature zone(Principal principal, String id) {
        return ZoneFeature.of(find(principal, id), principal.organisation());
    }

    /** One's own organisation's, unless it names a drone out of reach, and such as bind everybody. */
    public static boolean isShownTo(Principal principal, Zone zone) {
        if (!zone.organisation().equals(principal.organisation())) {
            return zone.isGlobal();
        }
        return !(zone.binding() instanceof ZoneBinding.OfDrone drone) || principal.sees(drone.id());
    }

    public ZoneFeature add(Principal principal, ZoneFeature feature) {
        RoleChecks.requireForAll(principal, Role.SUPERVISOR);
        Zone zone = read("", newId(), feature, principal);
        keep(List.of(zone));
        return ZoneFeature.of(zone, principal.organisation());
    }

    public ZoneFeature replace(Principal principal, String id, ZoneFeature feature) {
        RoleChecks.requireForAll(principal, Role.SUPERVISOR);
        Zone zone = read("", changeable(principal, id).id(), feature, principal);
        keep(List.of(zone));
        return ZoneFeature.of(zone, principal.organisation());
    }

    /** Files of others: what cannot be a zone is named, and the rest is added. */
    public ZoneImportView importZones(Principal principal, byte[] file) {
        RoleChecks.requireForAll(principal, Role.SUPERVISOR);
        ZoneFile found = ZoneImport.read(file);
        List<Zone> zones = new ArrayList<>();
        for (ZoneFile.Part part : found.parts()) {
            try {
                zones.add(read(part.at(), newId(), part.feature(), principal));
            } catch (InvalidInput e) {
                found.leaveOut(part, e);
            }
        }
        if (zones.isEmpty()) {
            throw found.nothing();
        }
        keep(zones);
        return ZoneImportView.of(zones, found.leftOut(), principal.organisation());
    }

    public synchronized void delete(Principal principal, String id) {
        RoleChecks.requireForAll(principal, Role.SUPERVISOR);
        if (!keeping.store().delete(changeable(principal, id).id())) {
            throw Rejection.unknown(NotFoundProblem.ZONE, id);
        }
        keeping.book().remove(id);
    }

    /** In one piece, so that store and book never part. */
    private synchronized void keep(List<Zone> zones) {
        OrganisationId owner =
                zones.isEmpty() ? OrganisationId.HOME : zones.get(0).organisation();
        List<String> known = keeping.book().zones().stream()
                .filter(zone -> zone.organisation().equals(owner))
                .map(Zone::id)
                .toList();
        long more = zones.stream().filter(zone -> !known.contains(zone.id())).count();
        if (known.size() + more > MOST) {
            throw Rejection.of(
                    ServerProblem.LIMIT_REACHED,
                    "There may be " + MOST + " zones at most; there are " + known.size() + " already, and these are "
                            + more
                            + " more. None was added: remove zones that are no longer needed, or import the part of"
                            + " the file where drones fly.",
                    ProblemParameter.WHAT.is("zones"),
                    ProblemParameter.MOST.is(MOST));
        }
        keeping.store().save(zones);
        keeping.book().put(zones);
    }

    private Zone read(String at, String id, ZoneFeature feature, Principal principal) {
        ZoneReader reader = new ZoneReader(at, feature);
        Instant now = clock.instant().truncatedTo(ChronoUnit.MILLIS);
        return new Zone(
                id,
                reader.name(),
                reader.shape(),
                reader.band(),
                known(at, reader.binding(), principal),
                reader.validity(now),
                reader.onBreach(),
                principal.name(),
                now,
                principal.organisation());
    }

    /** A slip of the pen must not make a zone that binds nobody. */
    private ZoneBinding known(String at, ZoneBinding binding, Principal principal) {
        if (binding instanceof ZoneBinding.OfUser user
                && keeping.users()
                        .user(user.name())
                        .filter(known -> known.organisation().equals(principal.organisation()))
                        .isEmpty()) {
            throw InvalidInput.outside(
                    ValueProblem.REFERENCE_UNKNOWN,
                    at + "properties.user",
                    "the name of a user",
                    "\"" + user.name() + "\"");
        }
        if (binding instanceof ZoneBinding.OfDrone drone
                && drones.find(principal, drone.id().value()).isEmpty()) {
            throw InvalidInput.outside(
                    ValueProblem.REFERENCE_UNKNOWN,
                    at + "properties.drone",
                    "the id of a drone",
                    "\"" + drone.id() + "\"");
        }
        return binding;
    }

    /** All of an organisation's, which is no more. */
    public synchronized void forget(OrganisationId organisation) {
        for (Zone zone : keeping.store().zones()) {
            if (zone.organisation().equals(organisation) && keeping.store().delete(zone.id())) {
                keeping.book().remove(zone.id());
            }
        }
    }

    private Zone changeable(Principal principal, String id) {
        Zone zone = find(principal, id);
        if (!zone.organisation().equals(principal.organisation())) {
            throw Rejection.of(AccessProblem.SERVER_ONLY, "This zone binds the whole server; ask those who run it.");
        }
        return zone;
    }

    private Zone find(Principal principal, String id) {
        return keeping.store().zones().stream()
                .filter(zone -> zone.id().equals(id) && isShownTo(principal, zone))
                .findFirst()
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.ZONE, id));
    }

    private static String newId() {
        return UUID.randomUUID().toString();
    }
}
