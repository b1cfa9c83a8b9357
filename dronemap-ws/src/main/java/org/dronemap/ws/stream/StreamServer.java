package org.dronemap.ws.stream;

import java.nio.channels.ClosedSelectorException;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronemap.core.time.FatalErrors;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RequestProblem;
import org.dronemap.ws.security.AuthenticatedCaller;
import org.dronemap.ws.security.CallerAuthenticator;
import org.dronemap.ws.security.StreamTickets;
import org.dronemap.ws.stream.delivery.TextFrameCache;
import org.dronemap.ws.stream.delivery.WriteReminder;
import org.java_websocket.WebSocket;
import org.java_websocket.framing.CloseFrame;
import org.java_websocket.framing.Framedata;
import org.java_websocket.handshake.ClientHandshake;
import org.java_websocket.server.WebSocketServer;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** WebSocket server of the stream: accepts connections and passes messages to {@link StreamRequestHandler}. */
public final class StreamServer extends WebSocketServer {
    private static final Logger LOG = LoggerFactory.getLogger(StreamServer.class);
    private static final int WORKERS = 2;
    public static final String PATH = "/stream";
    private static final String TICKET = "ticket=";
    private static final String FAREWELL = "The server stops.";
    private static final Pattern RATE = Pattern.compile("[?&]rate=(\\d{1,4})(?:&|$)");

    private final StreamRequestHandler requests;
    private final StreamClientRegistry crowd;
    private final CallerAuthenticator authentication;
    private final StreamTickets tickets;
    private final Runnable onNews;
    private final WriteReminder reminder = new WriteReminder(this::onWriteDemand);
    private final CompletableFuture<Integer> listening = new CompletableFuture<>();

    StreamServer(
            StreamFace.Port port,
            StreamRequestHandler requests,
            StreamClientRegistry crowd,
            CallerAuthenticator authentication,
            StreamTickets tickets,
            Runnable onNews) {
        super(port.address(), WORKERS, List.of(port.draft()));
        setWebSocketFactory(port.door());
        this.requests = requests;
        this.crowd = crowd;
        this.authentication = authentication;
        this.tickets = tickets;
        this.onNews = onNews;
        setReuseAddr(true);
        setTcpNoDelay(true);
        setDaemon(true);
        setConnectionLostTimeout(30);
    }

    /** The port once it listens. */
    CompletableFuture<Integer> listening() {
        return listening;
    }

    WriteReminder reminder() {
        return reminder;
    }

    Collection<StreamClient> clients() {
        return crowd.clients();
    }

    /** Tells everybody and stops. */
    void end() {
        // Told first: the library's thread goes some 25 ms after stop() began, and who is told later breaks the rest of
        // it.
        getConnections().forEach(socket -> socket.close(CloseFrame.GOING_AWAY, FAREWELL));
        try {
            stop(1_000, FAREWELL);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (ClosedSelectorException e) {
            LOG.debug("Somebody came while the stream server stopped, and was not told", e);
        }
    }

    @Override
    public void onOpen(WebSocket socket, ClientHandshake handshake) {
        StreamClient client = crowd.enter(socket);
        try {
            crowd.makeRoom();
            checkAddress(handshake);
            StreamRequestHandler.slowDown(client, rate(handshake.getResourceDescriptor()));
            identify(handshake).ifPresent(caller -> requests.welcome(client, caller));
        } catch (Rejection rejection) {
            requests.refused(rejection);
            requests.send(client, new StreamMessage.Failure(ProblemView.of(rejection), null));
            client.pump(System.nanoTime(), reminder, new TextFrameCache());
            client.close(CloseFrame.POLICY_VALIDATION, rejection.sentence());
        }
        onNews.run();
    }

    /** How many pictures of a drone a second are wanted at most; null when the address does not say. */
    private static @Nullable Integer rate(String address) {
        Matcher given = RATE.matcher(address);
        return given.find() ? Integer.valueOf(given.group(1)) : null;
    }

    @Override
    public void onClose(WebSocket socket, int code, String reason, boolean remote) {
        StreamClient client = crowd.of(socket);
        crowd.leave(socket);
        if (client != null) {
            requests.disconnected(client, code, remote);
            onNews.run();
        }
    }

    @Override
    public void onWebsocketPong(WebSocket socket, Framedata frame) {
        StreamClient client = crowd.of(socket);
        if (client != null) {
            client.answered(System.nanoTime());
        }
    }

    @Override
    public void onMessage(WebSocket socket, String message) {
        StreamClient client = crowd.of(socket);
        if (client != null) {
            requests.received(client, message);
            onNews.run();
        }
    }

    @Override
    public void onError(@Nullable WebSocket socket, Exception e) {
        FatalErrors.reportCause(e);
        if (socket == null) {
            if (!listening.completeExceptionally(e)) {
                LOG.error("The stream server failed", e);
            }
        } else {
            LOG.debug("A connection of the stream broke: {}", e.getMessage());
        }
    }

    @Override
    public void onStart() {
        listening.complete(getPort());
    }

    private Optional<AuthenticatedCaller> identify(ClientHandshake handshake) {
        String address = handshake.getResourceDescriptor();
        int query = address.indexOf(TICKET);
        if (query > 0) {
            String ticket = address.substring(query + TICKET.length()).split("&", 2)[0];
            return Optional.of(tickets.redeem(ticket)
                    .orElseThrow(() -> Rejection.of(
                            AccessProblem.TICKET_SPENT,
                            "The ticket was used already or is older than 30 s; ask for a new one.")));
        }
        String header = handshake.getFieldValue("Authorization");
        if (header.isEmpty()) {
            return Optional.empty();
        }
        return Optional.of(authentication.byKey(header.replaceFirst("(?i)^Bearer +", "")));
    }

    /** A page of another site must not open the stream in a visitor's name. */
    private static void checkAddress(ClientHandshake handshake) {
        String path = handshake.getResourceDescriptor().split("\\?", 2)[0];
        if (!path.equals(PATH)) {
            throw Rejection.of(
                    RequestProblem.ADDRESS_UNKNOWN,
                    "The stream is at " + PATH + ", not at " + path + ".",
                    ProblemParameter.ADDRESS.is(path));
        }
        String origin = handshake.getFieldValue("Origin");
        if (!origin.isEmpty()
                && !hostOf(origin.replaceFirst("^[a-z]+://", "")).equals(hostOf(handshake.getFieldValue("Host")))) {
            throw Rejection.of(
                    AccessProblem.ORIGIN_FOREIGN,
                    "The stream serves only pages of its own host, not of " + origin + ".",
                    ProblemParameter.ORIGIN.is(origin));
        }
    }

    private static String hostOf(String hostAndPort) {
        return hostAndPort.replaceFirst(":\\d+$", "");
    }
}
