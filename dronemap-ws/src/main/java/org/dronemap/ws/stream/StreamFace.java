package org.dronemap.ws.stream;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.Clock;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Predicate;
import org.dronemap.core.access.GrantBook;
import org.dronemap.core.access.Principal;
import org.dronemap.core.audit.AuditDesk;
import org.dronemap.core.cloud.CloudListener;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.Control;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneBook;
import org.dronemap.ws.security.Authentication;
import org.dronemap.ws.security.SignedIn;
import org.dronemap.ws.security.StreamTickets;
import org.dronemap.ws.service.AccessProblem;
import org.dronemap.ws.service.Accounts;
import org.dronemap.ws.service.Budgets;
import org.dronemap.ws.service.CommandService;
import org.dronemap.ws.service.CommandView;
import org.dronemap.ws.service.ControlService;
import org.dronemap.ws.service.ControlView;
import org.dronemap.ws.service.DroneService;
import org.dronemap.ws.service.DroneViews;
import org.dronemap.ws.service.FollowService;
import org.dronemap.ws.service.JsonReader;
import org.dronemap.ws.service.PlanDesk;
import org.dronemap.ws.service.Problem;
import org.dronemap.ws.service.Rejection;
import org.dronemap.ws.service.RunService;
import org.dronemap.ws.service.SteeringService;
import org.dronemap.ws.service.VirtualDroneViews;
import org.dronemap.ws.service.ZoneFeature;
import org.dronemap.ws.service.ZoneService;
import org.java_websocket.WebSocketServerFactory;
import org.java_websocket.drafts.Draft;
import org.java_websocket.framing.CloseFrame;

/** The WebSocket face as a whole. Lanes only put news down; one pump thread carries them to the clients. */
public final class StreamFace implements CloudListener, AutoCloseable {
    public static final int LARGEST_MESSAGE_BYTES = 256 * 1024;

    private static final long RETRY_NANOS = TimeUnit.MILLISECONDS.toNanos(5);
    private static final long TIME_TO_SIGN_IN_NANOS = TimeUnit.SECONDS.toNanos(5);

    private final CloudManager cloud;
    private final Services services;
    private final StreamServer server;
    private final StreamRequests requests;
    private final DroneFeed feed;
    private final VirtualFeed virtualFeed;
    private final PlanFeed planFeed;
    private final RunFeed runFeed;
    private final FollowFeed followFeed;
    private final StreamPhones phones;
    private final Clock clock;
    private final Pump pump = new Pump("stream-pump", this::round);
    private final Queue<DroneId> removed = new ConcurrentLinkedQueue<>();
    private final StreamSight sight;
    private final StreamBeat beat;

    /** The use cases behind the stream. */
    public record Services(
            Entrance entrance,
            DroneService drones,
            Pictures pictures,
            CommandService commands,
            Reins reins,
            JsonReader json) {}

    /** The address to listen at, the maker of connections, the reader of messages ({@link #LARGEST_MESSAGE_BYTES} at most). */
    public record Port(InetSocketAddress address, WebSocketServerFactory door, Draft draft) {}

    /** Who has control of drones, and who steers them by it. */
    public record Reins(ControlService controls, SteeringService steering) {}

    /** Who may come in, who has to leave, and where it is taken down. */
    public record Entrance(
            Authentication authentication,
            StreamTickets tickets,
            Accounts accounts,
            Bounds bounds,
            GrantBook grants,
            AuditDesk desk) {}

    /** How much users may do, and how many streams they may have. */
    public record Bounds(Budgets budgets, StreamCrowd crowd) {}

    /** What is shown, and how. */
    public record Pictures(
            DroneViews drones,
            VirtualDrones virtuals,
            VirtualDroneViews virtualViews,
            PlanDesk plans,
            RunService runs,
            FollowService follows) {}

    public StreamFace(CloudManager cloud, Services services, Port port, Clock clock) {
        this.cloud = cloud;
        this.services = services;
        this.clock = clock;
        this.beat = new StreamBeat(services.json(), clock, System.nanoTime());
        this.feed = new DroneFeed(services.pictures().drones(), services.json());
        this.sight = new StreamSight(cloud, services.entrance().grants(), feed, services.json());
        this.virtualFeed = new VirtualFeed(services.pictures(), services.json(), this::wake);
        this.planFeed = new PlanFeed(services.pictures().plans(), services.json(), this::wake);
        this.runFeed = new RunFeed(services.pictures().runs(), services.json(), this::wake);
        this.followFeed = new FollowFeed(services.pictures().follows(), services.json(), this::wake);
        this.phones = new StreamPhones(services.pictures().follows()::reached);
        this.requests = new StreamRequests(services, phones);
        services.entrance().accounts().onChangeFirst(this::judgeAnew);
        this.server = new StreamServer(
                port,
                requests,
                services.entrance().bounds().crowd(),
                services.entrance().authentication(),
                services.entrance().tickets(),
                pump::wake);
    }

    /** Returns the port when it listens. */
    public int start() throws IOException {
        server.start();
        int port = awaitListening();
        cloud.addListener(this);
        cloud.controls().watchedBy(this::isThere);
        cloud.zones().onChange(this::zonesChanged);
        services.pictures().virtuals().addListener(virtualFeed);
        services.pictures().plans().addListener(planFeed);
        services.pictures().runs().addListener(runFeed);
        services.pictures().follows().addListener(followFeed);
        pump.start();
        return port;
    }

    private boolean isThere(String user, DroneId drone) {
        return server.clients().stream()
                .filter(client -> client.wants(drone))
                .flatMap(client -> client.caller().stream())
                .anyMatch(caller -> caller.principal().name().equals(user));
    }

    private int awaitListening() throws IOException {
        try {
            return server.listening().get(10, TimeUnit.SECONDS);
        } catch (ExecutionException e) {
            throw new IOException(e.getCause());
        } catch (TimeoutException e) {
            throw new IOException("it does not listen after 10 s", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", e);
        }
    }

    @Override
    public void droneChanged(DroneState state) {
        feed.changed(state);
        virtualFeed.moved(state);
        followFeed.moved(state);
        wake();
    }

    @Override
    public void droneRemoved(DroneId id) {
        feed.removed(id);
        removed.add(id);
        wake();
    }

    /** Nobody stays connected by rights that are gone. */
    private void judgeAnew(String user) {
        for (StreamClient client : server.clients()) {
            client.caller()
                    .filter(caller -> caller.principal().name().equals(user))
                    .ifPresent(caller -> requests.judgeAnew(client, caller));
        }
        wake();
    }

    private void wake() {
        if (!server.clients().isEmpty()) {
            pump.wake();
        }
    }

    /** In the pump's own order, so that no picture follows the farewell. */
    private void tellRemoved(DroneId id) {
        feed.forget(id);
        String message = services.json().write(new StreamMessage.DroneRemoved(id.value()));
        for (StreamClient client : server.clients()) {
            client.outbox().forget(id);
            if (client.shown().remove(id) != null) {
                client.outbox().add(message);
            }
        }
    }

    @Override
    public void commandChanged(CommandRecord command) {
        tell(command.drone(), new StreamMessage.Command(CommandView.of(command)));
    }

    @Override
    public void controlChanged(DroneId drone, Control now, ControlChange change) {
        tell(drone, new StreamMessage.Control(drone.value(), ControlView.of(now), ControlView.ChangeView.of(change)));
    }

    /** What nobody who looks at that drone may miss. */
    private void tell(DroneId drone, Object news) {
        String message = services.json().write(news);
        for (StreamClient client : server.clients()) {
            if (client.sees(drone) && client.wants(drone)) {
                client.outbox().add(drone, message);
            }
        }
        wake();
    }

    private void zonesChanged(ZoneBook.Change change) {
        for (Zone former : change.former()) {
            // Who sees the new form is told that instead.
            List<Zone> now = change.put().stream()
                    .filter(zone -> zone.id().equals(former.id()))
                    .toList();
            tell(
                    new StreamMessage.ZoneRemoved(former.id()),
                    who -> ZoneService.isShownTo(who, former)
                            && now.stream().noneMatch(zone -> ZoneService.isShownTo(who, zone)));
        }
        change.put().forEach(this::tellOf);
        wake();
    }

    private void tellOf(Zone zone) {
        Map<OrganisationId, String> written = new HashMap<>();
        for (StreamClient client : server.clients()) {
            client.principal()
                    .filter(who -> ZoneService.isShownTo(who, zone))
                    .map(Principal::organisation)
                    .ifPresent(to -> client.outbox()
                            .add(written.computeIfAbsent(
                                    to,
                                    id -> services.json()
                                            .write(new StreamMessage.ZoneChanged(ZoneFeature.of(zone, id))))));
        }
    }

    private void tell(Object news, Predicate<Principal> whom) {
        String message = services.json().write(news);
        for (StreamClient client : server.clients()) {
            if (client.principal().filter(whom).isPresent()) {
                client.outbox().add(message);
            }
        }
    }

    private Pump.Pause round(long now) {
        for (DroneId id = removed.poll(); id != null; id = removed.poll()) {
            tellRemoved(id);
        }
        sight.settle(server.clients());
        virtualFeed.publish(server.clients(), now);
        planFeed.publish(server.clients(), now);
        runFeed.publish(server.clients(), now);
        followFeed.publish(server.clients(), now);
        phones.round(now);
        Pump.Pause pause = feed.publish(server.clients(), now);
        Optional<String> sign = beat.due(now);
        boolean allSent = true;
        for (StreamClient client : server.clients()) {
            allSent &= attend(client, sign, now);
        }
        return allSent ? pause : new Pump.Pause(pause.leastNanos(), Math.min(pause.mostNanos(), RETRY_NANOS));
    }

    private boolean attend(StreamClient client, Optional<String> sign, long now) {
        SignedIn caller = client.caller().orElse(null);
        if (caller == null) {
            if (now - client.connectedNanos() > TIME_TO_SIGN_IN_NANOS) {
                Rejection late = Rejection.of(
                        AccessProblem.SIGN_IN_NEEDED, "No ticket, key or authenticate message came within 5 s.");
                requests.say(client, new StreamMessage.Failure(Problem.of(late), null));
                client.pump(now, server.reminder());
                client.close(CloseFrame.POLICY_VALIDATION, late.sentence());
            }
        } else if (caller.until() != null && sign.isPresent() && !caller.until().isAfter(clock.instant())) {
            requests.expel(client, CloseFrame.POLICY_VALIDATION, Rejection.sessionEnded());
        } else {
            sign.ifPresent(client.outbox()::beat);
        }
        return client.pump(now, server.reminder());
    }

    /** How many clients are connected. */
    public int clientCount() {
        return server.clients().size();
    }

    @Override
    public void close() {
        cloud.removeListener(this);
        pump.close();
        server.end();
    }
}
