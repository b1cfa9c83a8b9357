package org.dronemap.ws.stream;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.Clock;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.audit.AuditRecorder;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.access.RestOperations;
import org.dronemap.ws.account.AccountChanges;
import org.dronemap.ws.budget.Budgets;
import org.dronemap.ws.command.CommandService;
import org.dronemap.ws.control.ControlService;
import org.dronemap.ws.control.SteeringService;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.drone.DroneViewMapper;
import org.dronemap.ws.follow.FollowService;
import org.dronemap.ws.plan.PlanJobExecutor;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.run.RunService;
import org.dronemap.ws.security.AuthenticatedCaller;
import org.dronemap.ws.security.CallerAuthenticator;
import org.dronemap.ws.security.StreamTickets;
import org.dronemap.ws.stream.delivery.PublishLoop;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.dronemap.ws.stream.delivery.StreamMessageSubject;
import org.dronemap.ws.stream.delivery.TextFrameCache;
import org.dronemap.ws.virtual.VirtualDroneViewMapper;
import org.java_websocket.WebSocketServerFactory;
import org.java_websocket.drafts.Draft;
import org.java_websocket.framing.CloseFrame;

/**
 * The WebSocket face as a whole: accepts clients, handles their requests and sends them all topics. One pump thread
 * carries to the clients what topics declare.
 */
public final class StreamFace implements AutoCloseable {
    public static final int LARGEST_MESSAGE_BYTES = 256 * 1024;

    private static final long RETRY_NANOS = TimeUnit.MILLISECONDS.toNanos(5);
    private static final long TIME_TO_SIGN_IN_NANOS = TimeUnit.SECONDS.toNanos(5);

    private final CloudManager cloud;
    private final StreamServer server;
    private final StreamRequestHandler requests;
    private final StreamEventRouter cloudNews = new StreamEventRouter();
    private final List<StreamTopic<?>> topics;
    private final StreamMessageCatalogue messages;
    private final StreamTopicPublisher news;
    private final PhoneReachability phones;
    private final Clock clock;
    private final PublishLoop pump = new PublishLoop("stream-pump", this::round);
    private final StreamHeartbeat beat;
    private final TextFrameCache frames = new TextFrameCache();

    /** The use cases behind the stream. */
    public record Services(
            AccessServices entrance,
            DroneService drones,
            ViewServices pictures,
            CommandService commands,
            ControlServices control,
            JsonCodec json) {}

    /** The address to listen at, the maker of connections, the reader of messages ({@link #LARGEST_MESSAGE_BYTES} at most). */
    public record Port(InetSocketAddress address, WebSocketServerFactory door, Draft draft) {}

    /** Services of the stream for control of drones and for steering them. */
    public record ControlServices(ControlService controls, SteeringService steering) {}

    /** Services of the stream for authentication, disconnection of users and audit records. */
    public record AccessServices(
            CallerAuthenticator authentication,
            StreamTickets tickets,
            AccountChanges accounts,
            Limits bounds,
            GrantRegistry grants,
            AuditRecorder audit) {}

    /** Limits of the stream: users' budgets, number of streams, and access rules of operations that REST has, too. */
    public record Limits(Budgets budgets, StreamClientRegistry crowd, RestOperations operations) {}

    /** Services and mappers that supply the views shown on the stream. */
    public record ViewServices(
            DroneViewMapper drones,
            VirtualDrones virtuals,
            VirtualDroneViewMapper virtualViews,
            PlanJobExecutor plans,
            RunService runs,
            FollowService follows) {}

    /** {@code ofUseCases}: the topics that are declared beside their use cases. */
    public StreamFace(CloudManager cloud, Services services, List<StreamTopic<?>> ofUseCases, Port port, Clock clock) {
        this.cloud = cloud;
        this.clock = clock;
        this.beat = new StreamHeartbeat(services.json(), clock, System.nanoTime());
        this.topics = StreamTopics.all(cloud, cloudNews, services.pictures(), ofUseCases);
        this.messages = StreamMessageCatalogue.of(topics);
        this.news = new StreamTopicPublisher(
                topics,
                services.entrance().grants(),
                services.json(),
                services.entrance().bounds().crowd(),
                pump::wake);
        this.phones = new PhoneReachability(services.pictures().follows()::reached);
        this.requests = new StreamRequestHandler(services, phones);
        services.entrance().accounts().onChangeFirst(this::reauthorize);
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
        cloud.controls().watchedBy(this::isThere);
        news.listen();
        cloud.addListener(cloudNews);
        pump.start();
        return port;
    }

    private boolean isThere(String user, DroneId drone) {
        return server.clients().stream()
                .filter(client -> client.wants(StreamMessageSubject.drone(drone)))
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

    /** Nobody stays connected by rights that are gone. */
    private void reauthorize(String user) {
        for (StreamClient client : server.clients()) {
            client.caller()
                    .filter(caller -> caller.principal().name().equals(user))
                    .ifPresent(caller -> requests.reauthorize(client, caller));
        }
        pump.wake();
    }

    private PublishLoop.Pause round(long now) {
        cloudNews.round(now);
        PublishLoop.Pause pause = news.publish(now);
        phones.round(now);
        Optional<String> sign = beat.due(now);
        boolean allSent = true;
        for (StreamClient client : server.clients()) {
            allSent &= attend(client, sign, now);
        }
        frames.clear();
        return allSent ? pause : new PublishLoop.Pause(pause.leastNanos(), Math.min(pause.mostNanos(), RETRY_NANOS));
    }

    private boolean attend(StreamClient client, Optional<String> sign, long now) {
        AuthenticatedCaller caller = client.caller().orElse(null);
        if (caller == null) {
            if (now - client.connectedNanos() > TIME_TO_SIGN_IN_NANOS) {
                Rejection late = Rejection.of(
                        AccessProblem.SIGN_IN_NEEDED, "No ticket, key or authenticate message came within 5 s.");
                requests.send(client, new StreamMessage.Failure(ProblemView.of(late), null));
                client.pump(now, server.reminder(), frames);
                client.close(CloseFrame.POLICY_VALIDATION, late.sentence());
            }
        } else if (caller.until() != null && sign.isPresent() && !caller.until().isAfter(clock.instant())) {
            requests.expel(client, CloseFrame.POLICY_VALIDATION, Rejection.sessionEnded());
        } else {
            sign.ifPresent(client.outbox()::beat);
        }
        return client.pump(now, server.reminder(), frames);
    }

    /** Hears what is to be told of drones. */
    public CloudListener news() {
        return cloudNews;
    }

    /** In the order in which a client that has come in is told of them. */
    public List<StreamTopic<?>> topics() {
        return topics;
    }

    public StreamMessageCatalogue messages() {
        return messages;
    }

    /** How many clients are connected. */
    public int clientCount() {
        return server.clients().size();
    }

    @Override
    public void close() {
        cloud.removeListener(cloudNews);
        pump.close();
        server.end();
    }
}
