package org.dronemap.proxy.outlet;

import java.time.Duration;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.time.Loop;
import org.dronemap.core.time.Time;
import org.dronemap.mavlink.Frame;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.outlet.client.ClientMessage;
import org.dronemap.proxy.outlet.client.ClientMessageFilter;
import org.dronemap.proxy.outlet.client.OutletClient;
import org.dronemap.proxy.outlet.client.OutletCounts;
import org.dronemap.proxy.outlet.client.OutletStatus;
import org.dronemap.proxy.outlet.client.OutletSystemIdRegistry;
import org.dronemap.proxy.outlet.rights.OutletCredential;
import org.dronemap.proxy.outlet.rights.OutletRightsWatch;
import org.dronemap.proxy.outlet.uplink.AttachedClients;
import org.dronemap.proxy.outlet.uplink.ClientMessageDispatcher;
import org.dronemap.proxy.outlet.uplink.VehicleFrameCache;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The single thread that serves all ground stations attached to the outlet, and the list of them. What comes in waits
 * in bounded queues; what happens to clients belongs to the thread.
 */
final class OutletLoop implements AttachedClients, AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(OutletLoop.class);
    private static final int MOST_CLIENTS = 200;
    private static final int MOST_FROM_CLIENTS = 4_096;
    private static final int MOST_FROM_VEHICLES = 16_384;
    private static final int AT_ONCE = 512;
    private static final long NAP_NANOS = 2_000_000L;
    private static final long SECOND_NANOS = 1_000_000_000L;
    private static final long TICK_NANOS = 10_000_000L;
    /** A datagram client that says nothing for so long gets nothing more: its address may be somebody else's by now. */
    private static final long SILENCE_NANOS = 30 * SECOND_NANOS;
    /** Whoever was disconnected stays outside for so long. */
    private static final long OUTSIDE_NANOS = 60 * SECOND_NANOS;
    /** Whoever may not look is not asked about again for so long. */
    private static final long REFUSED_NANOS = 2 * SECOND_NANOS;

    private static final int MOST_OF_A_USER = 20;
    private static final Duration LONGEST_CLOSE = Duration.ofSeconds(1);

    private final OutletCounts counts;
    private final Map<DroneId, VehicleFrameCache> vehicles = new ConcurrentHashMap<>();
    private final OutletRightsWatch rights;
    private final Queue<ClientFrame> fromClients = new ArrayBlockingQueue<>(MOST_FROM_CLIENTS);
    private final Queue<VehicleFrame> fromVehicles = new ArrayBlockingQueue<>(MOST_FROM_VEHICLES);
    private final Queue<Runnable> tasks = new ConcurrentLinkedQueue<>();
    private final Time time;
    private final Loop loop;
    private volatile List<OutletClient> all = List.of();
    private volatile List<OutletStatus.Client> shown = List.of();
    // From here on owned by the thread.
    private final Map<Peer, OutletClient> clients = new LinkedHashMap<>();
    private final Map<Peer, Long> outsideUntil = new HashMap<>();
    private final Map<Disconnected, Long> sentAwayUntil = new HashMap<>();
    private final OutletSystemIdRegistry numbers;
    private final ClientMessageDispatcher uplink;
    private int lastId;
    private long tickNanos;
    private long secondNanos;

    private record ClientFrame(Peer peer, OutletCredential pass, Frame frame) {}

    /** The user and host of a client that was disconnected, whatever its port. */
    private record Disconnected(String user, String host) {}

    private record VehicleFrame(DroneId drone, Frame frame) {}

    OutletLoop(OutletDependencies policy, OutletCounts counts, OutletRightsWatch rights) {
        this.rights = rights;
        this.time = policy.time();
        this.counts = counts;
        numbers = new OutletSystemIdRegistry(
                policy.store().numbers(),
                number -> policy.journal()
                        .write(
                                "what " + number.user() + " calls a drone",
                                () -> policy.store().saveNumber(number),
                                () -> {}));
        loop = time.loop("outlet", this::turn);
        uplink = new ClientMessageDispatcher(policy.cloud(), policy.control(), counts, vehicles, this, time);
    }

    /** On the clients' thread, soon. Any thread. */
    @Override
    public void later(Runnable task) {
        tasks.add(task);
        loop.wake();
    }

    void start() {
        secondNanos = time.nanos();
        loop.start();
    }

    /** False when there was no room. Any thread. */
    boolean receivedFromClient(Peer peer, OutletCredential pass, Frame frame) {
        boolean taken = fromClients.offer(new ClientFrame(peer, pass, frame));
        loop.wake();
        return taken;
    }

    /** Dropped and counted when the clients' thread is behind. Any thread. */
    void receivedFromVehicle(DroneId drone, Frame frame) {
        if (!all.isEmpty() && !fromVehicles.offer(new VehicleFrame(drone, frame))) {
            counts.unread();
        }
    }

    /** Any thread. */
    void gone(Peer peer) {
        tasks.add(() -> {
            outsideUntil.remove(peer);
            end(peer, "its link has ended");
        });
    }

    /** Clients whose passphrase was changed or taken away, or whose port was closed, end. Any thread. */
    void keysChanged() {
        tasks.add(() -> List.copyOf(clients.values()).stream()
                .filter(client -> client.pass().isWithdrawn())
                .forEach(client -> end(client.peer(), "it is no longer let in")));
    }

    /** From now on clients are answered from what is kept of this vehicle. Any thread. */
    void vehicleConnected(DroneId drone, VehicleFrameCache vehicle) {
        vehicles.put(drone, vehicle);
    }

    /** Nothing happens when another one of the same drone came in its place. Any thread. */
    void vehicleDisconnected(DroneId drone, VehicleFrameCache vehicle) {
        vehicles.remove(drone, vehicle);
    }

    /** Any thread. */
    void forget(DroneId drone) {
        vehicles.remove(drone);
        tasks.add(() -> numbers.forget(drone));
    }

    /** False when there is no such client. Any thread. */
    boolean disconnect(String id) {
        OutletClient found = all.stream()
                .filter(client -> client.id().equals(id))
                .findFirst()
                .orElse(null);
        if (found == null) {
            return false;
        }
        tasks.add(() -> {
            Disconnected whom =
                    new Disconnected(found.user(), found.peer().address().host());
            sentAwayUntil.put(whom, time.nanos() + OUTSIDE_NANOS);
            end(found.peer(), "somebody disconnected it");
        });
        loop.wake();
        return true;
    }

    /** Any thread. */
    @Override
    public List<OutletClient> clients() {
        return all;
    }

    /** Who is there now, with figures at most a second old. Any thread. */
    OutletStatus status(List<OutletStatus.Port> ports) {
        return new OutletStatus(shown, ports, counts.refused(), counts.unreadFrames(), counts.notPassedFrames());
    }

    private long turn() {
        for (Runnable task = tasks.poll(); task != null; task = tasks.poll()) {
            task.run();
        }
        long now = time.nanos();
        int count = 0;
        for (ClientFrame heard = fromClients.poll();
                heard != null;
                heard = count < AT_ONCE ? fromClients.poll() : null) {
            dispatch(heard, now);
            count++;
        }
        for (VehicleFrame said = fromVehicles.poll();
                said != null;
                said = count < 2 * AT_ONCE ? fromVehicles.poll() : null) {
            show(said);
            count++;
        }
        if (now - tickNanos >= TICK_NANOS) {
            tickNanos = now;
            uplink.advance(now);
        }
        clients.values().forEach(OutletClient::flush);
        if (now - secondNanos >= SECOND_NANOS) {
            secondNanos = now;
            second(now);
        }
        return count >= AT_ONCE ? 0 : NAP_NANOS;
    }

    private void show(VehicleFrame said) {
        boolean event = ClientMessageFilter.isEvent(said.frame());
        ClientMessage.OfVehicle letter = new ClientMessage.OfVehicle(said.drone(), said.frame());
        for (OutletClient client : clients.values()) {
            client.forward(letter, event);
        }
    }

    private void dispatch(ClientFrame heard, long now) {
        if (heard.pass().isWithdrawn()) {
            return;
        }
        OutletClient client = clients.get(heard.peer());
        if (client != null && client.pass() == heard.pass()) {
            client.received(now);
            uplink.dispatch(client, heard.frame(), now);
        } else {
            requestAdmission(heard, now);
        }
    }

    /** Asks once what a new client's user may do; what it sends meanwhile is lost, and is sent again by all who need it. */
    private void requestAdmission(ClientFrame heard, long now) {
        Disconnected whom =
                new Disconnected(heard.pass().user(), heard.peer().address().host());
        if (isBefore(now, outsideUntil.get(heard.peer())) || isBefore(now, sentAwayUntil.get(whom))) {
            counts.turnedAway();
            return;
        }
        outsideUntil.put(heard.peer(), now + REFUSED_NANOS);
        if (!rights.ask(heard.pass().user(), principal -> tasks.add(() -> admit(heard, principal)))) {
            counts.turnedAway();
        }
    }

    private static boolean isBefore(long now, @Nullable Long until) {
        return until != null && now - until < 0;
    }

    private void admit(ClientFrame heard, @Nullable Principal principal) {
        OutletCredential pass = heard.pass();
        long ofUser = clients.values().stream()
                .filter(client -> client.user().equals(pass.user()))
                .count();
        if (principal == null
                || !principal.may(Role.VIEWER)
                || pass.isWithdrawn()
                || clients.size() >= MOST_CLIENTS
                || ofUser >= MOST_OF_A_USER) {
            counts.turnedAway();
            return;
        }
        end(heard.peer(), "another user's program speaks from there now");
        outsideUntil.remove(heard.peer());
        long now = time.nanos();
        OutletClient.Entry entry = new OutletClient.Entry(
                "client-" + ++lastId,
                pass,
                heard.frame().systemId(),
                time.clock().instant(),
                now);
        OutletClient client = new OutletClient(entry, heard.peer(), numbers, principal);
        clients.put(heard.peer(), client);
        list(now);
        LOG.info(
                "{} attached to the outlet from {} as {}",
                client.user(),
                heard.peer().address(),
                client.id());
    }

    private void end(Peer peer, String why) {
        OutletClient client = clients.remove(peer);
        if (client != null) {
            list(time.nanos());
            uplink.forget(client);
            LOG.info("{} of {} left the outlet: {}", client.id(), client.user(), why);
        }
    }

    private void second(long now) {
        for (OutletClient client : List.copyOf(clients.values())) {
            Principal principal = client.principal();
            if (client.pass().isWithdrawn()) {
                end(client.peer(), "it is no longer let in");
            } else if (principal == null || !principal.may(Role.VIEWER)) {
                end(client.peer(), "its user may look no more");
            } else if (client.peer().isDatagram() && client.silenceNanos(now) > SILENCE_NANOS) {
                end(client.peer(), "it said nothing for half a minute");
            } else {
                client.second();
                if (vehicles.keySet().stream().noneMatch(client::sees)) {
                    client.sendHeartbeat();
                }
            }
        }
        uplink.second();
        outsideUntil.values().removeIf(until -> now - until > 0);
        sentAwayUntil.values().removeIf(until -> now - until > 0);
        list(now);
    }

    private void list(long now) {
        all = List.copyOf(clients.values());
        shown = all.stream().map(client -> client.status(now)).toList();
    }

    @Override
    public void close() {
        uplink.close();
        if (!loop.finish(LONGEST_CLOSE)) {
            LOG.warn("The outlet was still busy with its clients when it was closed");
        }
    }
}
