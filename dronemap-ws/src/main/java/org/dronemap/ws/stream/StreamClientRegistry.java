package org.dronemap.ws.stream;

import java.util.Collection;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.Consumer;
import org.dronemap.core.access.Principal;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.security.AuthenticatedCaller;
import org.java_websocket.WebSocket;
import org.jspecify.annotations.Nullable;

/** Registry of clients connected to the WebSocket stream, with limits in all and for each user. Any thread. */
public final class StreamClientRegistry {
    private static final int MOST_CLIENTS = 2_000;

    private final int mostOfOneUser;
    private final Consumer<WebSocket> onAdmission;
    private final ConcurrentHashMap<WebSocket, StreamClient> clients = new ConcurrentHashMap<>();
    private final LongAdder turnedAway = new LongAdder();

    /** {@code onAdmission}: what is done with the connection of somebody who signed in. */
    public StreamClientRegistry(int mostOfOneUser, Consumer<WebSocket> onAdmission) {
        this.mostOfOneUser = mostOfOneUser;
        this.onAdmission = onAdmission;
    }

    Collection<StreamClient> clients() {
        return clients.values();
    }

    @Nullable
    StreamClient of(WebSocket socket) {
        return clients.get(socket);
    }

    StreamClient enter(WebSocket socket) {
        StreamClient client = new StreamClient(socket, System.nanoTime());
        clients.put(socket, client);
        return client;
    }

    void leave(WebSocket socket) {
        clients.remove(socket);
    }

    /** Says no to who is one too many for the server as a whole. */
    void makeRoom() {
        if (clients.size() > MOST_CLIENTS) {
            turnedAway.increment();
            throw Rejection.of(
                    ServerProblem.SERVER_BUSY, "Too many clients are connected.", ProblemParameter.WHAT.is("clients"));
        }
    }

    /**
     * Says no to who is one too many of one user. Admitted first and counted then: of two who come at the same moment both
     * may be turned away, but never does one too many stay.
     */
    void admit(StreamClient client, AuthenticatedCaller who) {
        client.admit(who);
        String user = who.principal().name();
        long open = clients.values().stream()
                .filter(each -> each.principal()
                        .map(Principal::name)
                        .filter(user::equals)
                        .isPresent())
                .count();
        if (open > mostOfOneUser) {
            turnedAway.increment();
            throw Rejection.of(
                    ServerProblem.STREAMS_SPENT,
                    "As many streams are open as one user may have (" + mostOfOneUser + "); close one first.",
                    ProblemParameter.MOST.is(mostOfOneUser));
        }
        onAdmission.accept(client.socket());
    }

    /** How many found no place since the start. */
    public long turnedAwayCount() {
        return turnedAway.sum();
    }
}
