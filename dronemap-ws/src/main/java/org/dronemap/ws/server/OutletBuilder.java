package org.dronemap.ws.server;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.OutletStore;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.User;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.time.Time;
import org.dronemap.proxy.endpoint.EndpointSecurity;
import org.dronemap.proxy.endpoint.EndpointUrl;
import org.dronemap.proxy.outlet.Outlet;
import org.dronemap.proxy.outlet.OutletDependencies;
import org.dronemap.proxy.outlet.rights.OutletRights;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.settings.OutletSettings;

/** Builds and opens the outlet, where third-party ground stations attach. */
final class OutletBuilder {
    private final OutletSettings settings;
    private final Time time;
    private final List<EndpointUrl> urls;

    OutletBuilder(OutletSettings settings, Time time) {
        this.settings = settings;
        this.time = time;
        urls = settings.urls().stream().map(OutletBuilder::url).toList();
    }

    private static EndpointUrl url(String text) {
        try {
            EndpointUrl url = EndpointUrl.parse(text);
            if (url.kind().isListener()) {
                return url;
            }
        } catch (IllegalArgumentException e) {
            throw new SetupException("DRONEMAP_OUTLET: " + e.getMessage(), e);
        }
        throw new SetupException(
                "DRONEMAP_OUTLET: \"" + text + "\" cannot be an outlet; write udpserver://, tcpserver://,"
                        + " wsserver://, wssserver:// or dtlsserver://, or off.");
    }

    Outlet build(
            AuditedOutletControl control,
            OutletStore store,
            StoreWriter journal,
            AccountOutletRights rights,
            EndpointSecurity doors) {
        CloudManager cloud = control.cloud();
        OutletDependencies policy = new OutletDependencies(cloud, store, journal, rights, control, time);
        Outlet outlet = new Outlet(urls, settings.personal(), policy, doors);
        cloud.addListener(new RemovedDroneListener(outlet));
        cloud.controls().watchedBy((user, drone) -> outlet.isAttached(user));
        return outlet;
    }

    /** Lets clients in. A port of a setting must be free; the usual ones may be another server's for now. */
    void open(Outlet outlet) {
        try {
            outlet.start(settings.usual());
        } catch (IOException e) {
            throw new SetupException(e.getMessage() + " (DRONEMAP_OUTLET)", e);
        }
    }

    private record RemovedDroneListener(Outlet outlet) implements CloudListener {
        @Override
        public void droneRemoved(DroneId id) {
            outlet.forget(id);
        }
    }

    /** Rights of a user whose ground station attaches to the outlet: the same as anywhere else. */
    record AccountOutletRights(AccessStore store, GrantRegistry grants) implements OutletRights {
        @Override
        public Optional<Principal> principal(String user) {
            return store.user(user)
                    .filter(User::isActive)
                    .map(active -> Principal.of(
                            active,
                            active.role(),
                            KeyScope.ALL,
                            null,
                            grants.permissionsOf(active.organisation(), active.name())));
        }
    }
}
