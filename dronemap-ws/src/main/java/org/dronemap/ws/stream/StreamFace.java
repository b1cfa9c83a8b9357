package org.dronemap.ws.stream;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.Clock;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.audit.AuditRecorder;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.access.RestOperations;
import org.dronemap.ws.account.AccountChanges;
import org.dronemap.ws.budget.Budgets;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.security.AuthenticatedCaller;
import org.dronemap.ws.security.CallerAuthenticator;
import org.dronemap.ws.security.StreamTickets;
import org.dronemap.ws.stream.delivery.PublishLoop;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.dronemap.ws.stream.delivery.StreamMessageSubject;
import org.dronemap.ws.stream.delivery.TextFrameCache;
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
    private final StreamEventRouter cloudNews;
    private final List<StreamTopic<?>> topics;
    private final StreamMessageCatalogue messages;
    private final StreamRequestCatalogue catalogue;
    private final RestOperations operations;
    private final StreamTopicPublisher news;
    private final List<StreamConnectionListener> listeners;
    private final Clock clock;
    private final PublishLoop pump = new PublishLoop("stream-pump", this::round);
    private final StreamHeartbeat beat;
    private final TextFrameCache frames = new TextFrameCache();

    /** The parts of the server that the stream needs, and its version. */
    public record Services(AccessServices entrance, Features features, JsonCodec json, String version) {}

    /** Declarations of all rooms of features, each in the order in which they are told, named or called. */
    public record Features(
            List<StreamTopic<?>> topics,
            List<StreamOperation<?>> operations,
            List<StreamWelcome> welcomes,
            List<StreamConnectionListener> listeners) {}

    /** The address to listen at, the maker of connections, the reader of messages ({@link #LARGEST_MESSAGE_BYTES} at most). */
    public record Port(InetSocketAddress address, WebSocketServerFactory door, Draft draft) {}

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

    /** {@code cloudNews}: hears from the cloud as soon as the face has started. */
    public StreamFace(CloudManager cloud, StreamEventRouter cloudNews, Services services, Port port, Clock clock) {
        this.cloud = cloud;
        this.cloudNews = cloudNews;
        this.clock = clock;
        this.beat = new StreamHeartbeat(services.json(), clock, System.nanoTime());
        this.topics = services.features().topics();
        this.messages = StreamMessageCatalogue.of(topics, others(services.features()));
        this.catalogue = StreamRequestCatalogue.of(services.features().operations());
        this.operations = services.entrance().bounds().operations();
        this.listeners = services.features().listeners();
        this.news = new StreamTopicPublisher(
                topics,
                services.entrance().grants(),
                services.json(),
                services.entrance().bounds().crowd(),
                pump::wake);
        this.requests = new StreamRequestHandler(services, catalogue);
        services.entrance().accounts().onChangeFirst(this::reauthorize);
        this.server = new StreamServer(
                port,
                requests,
                services.entrance().bounds().crowd(),
                services.entrance().authentication(),
                services.entrance().tickets(),
                pump::wake);
    }

    /** Messages that belong to no topic: those that come first, and answers. */
    private static List<Class<? extends StreamMessage>> others(Features features) {
        Stream<Class<? extends StreamMessage>> first =
                features.welcomes().stream().map(StreamWelcome::message);
        Stream<Class<? extends StreamMessage>> answers =
                features.operations().stream().flatMap(operation -> operation.type().answer().stream());
        return Stream.concat(first, answers).toList();
    }

    /** Returns the port when it listens; fails where a request is judged as an operation that REST does not have. */
    public int start() throws IOException {
        catalogue.types().values().forEach(type -> type.access().operations().forEach(operations::rule));
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
        listeners.forEach(listener -> listener.round(now));
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

    public StreamRequestCatalogue requests() {
        return catalogue;
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
