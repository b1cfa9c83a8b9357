package org.dronemap.ws.stream;

import java.util.Map;
import org.dronemap.ws.access.AccessRule;
import org.dronemap.ws.access.Audit;
import org.dronemap.ws.access.Cost;
import org.dronemap.ws.access.From;
import org.dronemap.ws.access.RestOperations;
import org.dronemap.ws.control.ControlAction;

/** Access rules of all stream requests, taken from the REST operation of the same effect. */
final class StreamRules {
    private static final StreamRule AUTHENTICATE = new StreamRule.OnlyHere(
            From.ANYBODY, Cost.NOTHING, Audit.REFUSALS_ONLY, "REST is shown a key with each request, a stream once.");
    private static final StreamRule COMMAND = new StreamRule.OfOperation("giveCommand");
    private static final StreamRule CONTROL = new StreamRule.OfControl(Map.of(
            ControlAction.TAKE, "takeControl",
            ControlAction.REQUEST, "requestControl",
            ControlAction.GRANT, "grantControl",
            ControlAction.REFUSE, "refuseControl",
            ControlAction.HAND_OVER, "handOverControl",
            ControlAction.TAKE_OVER, "takeOverControl",
            ControlAction.HEARTBEAT, "keepControl",
            ControlAction.RELEASE, "releaseControl"));
    private static final StreamRule STEER = new StreamRule.OnlyHere(
            From.VIEWER,
            Cost.NOTHING,
            Audit.REFUSALS_ONLY,
            "Setpoints come many times a second; role and budget are judged where the same refusal is told once in one.");
    private static final StreamRule LET_GO = new StreamRule.OnlyHere(
            From.OPERATOR, Cost.NOTHING, Audit.REFUSALS_ONLY, "It ends what is steered, which REST cannot do.");
    private static final StreamRule POSITIONS = new StreamRule.OfOperation("reportFollowPositions");
    private static final StreamRule SUBSCRIBE = new StreamRule.OnlyHere(
            From.VIEWER, Cost.REQUEST, Audit.LEFT_OUT, "It is about what this connection is told.");
    private static final StreamRule PING = new StreamRule.OnlyHere(
            From.VIEWER, Cost.REQUEST, Audit.LEFT_OUT, "It asks whether this connection stands.");

    private final RestOperations operations;

    StreamRules(RestOperations operations) {
        this.operations = operations;
    }

    AccessRule rule(StreamRequest request) {
        return of(request.kind()).of(request, operations::rule);
    }

    static StreamRule of(StreamRequestKind kind) {
        return switch (kind) {
            case AUTHENTICATE -> AUTHENTICATE;
            case COMMAND -> COMMAND;
            case CONTROL -> CONTROL;
            case STEER -> STEER;
            case LET_GO -> LET_GO;
            case POSITIONS -> POSITIONS;
            case SUBSCRIBE -> SUBSCRIBE;
            case PING -> PING;
        };
    }
}
