package org.dronemap.proxy.outlet;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import org.dronemap.core.time.Time;
import org.dronemap.proxy.endpoint.DtlsKeys;
import org.dronemap.proxy.endpoint.Endpoint;
import org.dronemap.proxy.endpoint.EndpointSecurity;
import org.dronemap.proxy.endpoint.EndpointUrl;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.outlet.client.OutletStatus;
import org.dronemap.proxy.outlet.rights.AddressRange;
import org.dronemap.proxy.outlet.rights.PortRange;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The open personal ports of the outlet, closed on request, when their time is up, or with the server. Any thread. */
final class PersonalPorts implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(PersonalPorts.class);
    private static final int MOST_OF_A_USER = 3;

    private final Function<PersonalPort.Terms, PersonalPort> making;
    private final PortRange range;
    private final Optional<String> host;
    private final Time time;
    // guarded by this
    private final Map<String, Open> ports = new LinkedHashMap<>();
    private int lastId;

    private record Open(PersonalPort port, Endpoint endpoint) {}

    /**
     * Opens them where {@code urls} listen for datagrams, at the ports of {@code range}; {@code making} makes what serves
     * one on its terms.
     */
    PersonalPorts(
            Function<PersonalPort.Terms, PersonalPort> making, List<EndpointUrl> urls, PortRange range, Time time) {
        this.making = making;
        this.range = range;
        host = urls.stream()
                .filter(url -> url.kind() == EndpointUrl.Kind.UDPSERVER)
                .map(EndpointUrl::host)
                .findFirst();
        this.time = time;
    }

    /**
     * Opens one.
     *
     * @throws IllegalStateException with a sentence when there can be no more
     */
    synchronized OutletStatus.Port open(String user, AddressRange allowed, Duration length) {
        long own = ports.values().stream()
                .filter(open -> open.port().user().equals(user))
                .count();
        if (own >= MOST_OF_A_USER) {
            throw new IllegalStateException("You have " + MOST_OF_A_USER + " personal ports already; close one first.");
        }
        Instant now = time.clock().instant();
        PersonalPort.Terms terms = new PersonalPort.Terms(
                "port-" + ++lastId, user, allowed, now, now.plus(length), time.nanos() + length.toNanos());
        PersonalPort port = making.apply(terms);
        Open open = new Open(port, endpoint(port));
        ports.put(terms.id(), open);
        LOG.info("{} opened {} for {} until {}", user, open.endpoint().url(), allowed, terms.until());
        return status(open);
    }

    private Endpoint endpoint(PersonalPort port) {
        for (int number = range.first(); host.isPresent() && number <= range.last(); number++) {
            try {
                EndpointUrl url = EndpointUrl.parse("udpserver://" + host.get() + ":" + number);
                return Endpoint.open(url, port, EndpointSecurity.of(DtlsKeys.none()), time);
            } catch (IOException taken) {
                LOG.debug("{} is no port to open", number, taken);
            }
        }
        throw new IllegalStateException(
                host.isEmpty() || range.isEmpty()
                        ? "This server opens no personal ports."
                        : "All personal ports are taken; try again later.");
    }

    /** False when there is none of that name. */
    boolean close(String id) {
        return end(open -> open.port().terms().id().equals(id), "was closed");
    }

    /** Closes all of one user. */
    void closeOf(String user) {
        end(open -> open.port().user().equals(user), "lost its user");
    }

    /** Closes those whose time is up. */
    void sweep() {
        end(open -> open.port().isWithdrawn(), "is over");
    }

    private boolean end(Predicate<Open> which, String why) {
        List<Open> ended;
        synchronized (this) {
            ended = ports.values().stream().filter(which).toList();
            ended.forEach(open -> ports.remove(open.port().terms().id()));
        }
        for (Open open : ended) {
            open.port().withdraw();
            open.endpoint().close();
            LOG.info("{} of {} {}", open.endpoint().url(), open.port().user(), why);
        }
        return !ended.isEmpty();
    }

    synchronized List<OutletStatus.Port> all() {
        List<OutletStatus.Port> all = new ArrayList<>();
        ports.values().forEach(open -> all.add(status(open)));
        return all;
    }

    private static OutletStatus.Port status(Open open) {
        PersonalPort.Terms terms = open.port().terms();
        PeerAddress first = open.port().first();
        return new OutletStatus.Port(
                terms.id(),
                terms.user(),
                open.endpoint().url().toString(),
                terms.range().toString(),
                first == null ? null : first.toString(),
                open.port().refused(),
                terms.since(),
                terms.until());
    }

    @Override
    public void close() {
        end(open -> true, "ends with the server");
    }
}
