package org.dronemap.proxy.outlet;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.time.Time;
import org.dronemap.proxy.endpoint.EndpointRegistry;
import org.dronemap.proxy.endpoint.EndpointSecurity;
import org.dronemap.proxy.endpoint.EndpointUrl;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.proxy.outlet.client.OutletCounts;
import org.dronemap.proxy.outlet.client.OutletStatus;
import org.dronemap.proxy.outlet.rights.AddressRange;
import org.dronemap.proxy.outlet.rights.OutletKeys;
import org.dronemap.proxy.outlet.rights.OutletRightsWatch;
import org.dronemap.proxy.outlet.rights.PortRange;
import org.dronemap.proxy.session.FrameTap;

/**
 * The MAVLink service to which users' own ground stations (QGroundControl and others) attach, on a thread of its own.
 * Endpoints bring what clients send, taps what vehicles say, and one thread of its own serves the clients: no vehicle's
 * path ever waits for one of them. Any thread.
 */
public final class Outlet implements PeerHandler.Factory, FrameTap.Factory, AutoCloseable {
    private final List<EndpointUrl> urls;
    private final Time time;
    private final OutletKeys keys;
    private final OutletCounts counts = new OutletCounts();
    private final OutletLoop loop;
    private final OutletRightsWatch rights;
    private final EndpointRegistry links;
    private final PersonalPorts ports;

    /**
     * Opens nothing before {@link #start}; clients come in over listeners that prove nothing of their own but
     * DTLS, which users' programs open by name and key; of {@code doors} it takes the rest.
     */
    public Outlet(List<EndpointUrl> urls, OutletDependencies policy, EndpointSecurity doors) {
        this(urls, PortRange.NONE, policy, doors);
    }

    /** {@code personal}: where users may open ports of their own. */
    public Outlet(List<EndpointUrl> urls, PortRange personal, OutletDependencies policy, EndpointSecurity doors) {
        this.urls = List.copyOf(urls);
        time = policy.time();
        keys = new OutletKeys(policy.store(), time);
        rights = new OutletRightsWatch(policy.rights(), keys, time);
        loop = new OutletLoop(policy, counts, rights);
        links = new EndpointRegistry(
                this, new EndpointSecurity(keys::dtlsSecret, doors.tls(), doors.limits(), doors.watch()), time);
        ports = new PersonalPorts(this::personalPort, urls, personal, time);
    }

    /** Looks at once what the users of all clients may do now; may wait for the store. */
    public void judgeAnew() {
        rights.judge(loop.clients());
    }

    /**
     * Opens all endpoints or none.
     *
     * @param patient a port that is taken is tried again later, and no failure
     * @throws IOException with a sentence that says which one and why
     */
    public void start(boolean patient) throws IOException {
        loop.start();
        rights.start(loop::clients, ports::sweep);
        for (int number = 0; number < urls.size(); number++) {
            String id = "outlet-" + (number + 1);
            if (patient) {
                links.retryLater(id, urls.get(number));
            } else {
                links.open(id, urls.get(number));
            }
        }
    }

    /** Where it really listens. */
    public List<EndpointUrl> endpoints() {
        return links.all().stream().map(EndpointRegistry.Status::url).toList();
    }

    /** Whether that user has a passphrase. */
    public boolean hasKey(String user) {
        return keys.has(user);
    }

    /** From now on the user's programs sign with this; false when somebody else uses it already. Waits for the store. */
    public boolean putKey(String user, LinkKey key) {
        boolean done = keys.put(user, key);
        loop.keysChanged();
        return done;
    }

    /** The user's programs stay outside from now on; false when they did already. Waits for the store. */
    public boolean removeKey(String user) {
        boolean removed = keys.remove(user);
        loop.keysChanged();
        return removed;
    }

    public OutletStatus status() {
        return loop.status(ports.all());
    }

    /**
     * Opens a port of the user's own, for a program that cannot sign and that only looks: for the first address within
     * {@code allowed} that speaks there. It ends with the time, or with the server.
     *
     * @throws IllegalStateException with a sentence when there can be no more
     */
    public OutletStatus.Port openPort(String user, AddressRange allowed, Duration time) {
        return ports.open(user, allowed, time);
    }

    /** False when there is no such port. */
    public boolean closePort(String id) {
        boolean closed = ports.close(id);
        loop.keysChanged();
        return closed;
    }

    /** Closes all ports of a user's own. */
    public void closePortsOf(String user) {
        ports.closeOf(user);
        loop.keysChanged();
    }

    /** Ends a client, which may come back in a minute; false when there is no such client. */
    public boolean disconnect(String id) {
        return loop.disconnect(id);
    }

    /** Whether a program of that user is attached. */
    public boolean isAttached(String user) {
        return loop.clients().stream().anyMatch(client -> client.user().equals(user));
    }

    /** A drone is removed: its numbers are free. */
    public void forget(DroneId drone) {
        loop.forget(drone);
    }

    @Override
    public PeerHandler opened(Peer peer, PeerCounters counters) {
        return new OutletPeerHandler(loop, keys, counts, peer, counters);
    }

    @Override
    public FrameTap open(int componentId) {
        return new OutletFrameTap(loop, componentId);
    }

    /** Serves a port of a user's own on these terms, once an endpoint is opened for it. */
    PersonalPort personalPort(PersonalPort.Terms terms) {
        return new PersonalPort(loop, counts, terms, time::nanos);
    }

    @Override
    public void close() {
        links.close();
        ports.close();
        rights.close();
        loop.close();
    }
}
