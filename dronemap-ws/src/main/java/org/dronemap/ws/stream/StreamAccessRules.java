package org.dronemap.ws.stream;

import java.util.Map;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.AccessRule;
import org.dronemap.ws.access.AuditPolicy;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.access.RestOperations;
import org.dronemap.ws.control.ControlAction;

/** Access rules of all requests on the WebSocket stream, taken from the REST operations of the same effect. */
public final class StreamAccessRules {
    private static final StreamAccessRule AUTHENTICATE = new StreamAccessRule.StreamOnly(
            AccessLevel.ANYBODY,
            RequestCost.NOTHING,
            AuditPolicy.REFUSALS_ONLY,
            "REST is shown a key with each request, a stream once.");
    private static final StreamAccessRule COMMAND = new StreamAccessRule.OfOperation("giveCommand");
    private static final StreamAccessRule CONTROL = new StreamAccessRule.OfControl(Map.of(
            ControlAction.TAKE, "takeControl",
            ControlAction.REQUEST, "requestControl",
            ControlAction.GRANT, "grantControl",
            ControlAction.REFUSE, "refuseControl",
            ControlAction.HAND_OVER, "handOverControl",
            ControlAction.TAKE_OVER, "takeOverControl",
            ControlAction.HEARTBEAT, "keepControl",
            ControlAction.RELEASE, "releaseControl"));
    private static final StreamAccessRule STEER = new StreamAccessRule.StreamOnly(
            AccessLevel.VIEWER,
            RequestCost.NOTHING,
            AuditPolicy.REFUSALS_ONLY,
            "Setpoints come many times a second; role and budget are judged where the same refusal is told once in one.");
    private static final StreamAccessRule LET_GO = new StreamAccessRule.StreamOnly(
            AccessLevel.OPERATOR,
            RequestCost.NOTHING,
            AuditPolicy.REFUSALS_ONLY,
            "It ends what is steered, which REST cannot do.");
    private static final StreamAccessRule POSITIONS = new StreamAccessRule.OfOperation("reportFollowPositions");
    private static final StreamAccessRule SUBSCRIBE = new StreamAccessRule.StreamOnly(
            AccessLevel.VIEWER, RequestCost.REQUEST, AuditPolicy.LEFT_OUT, "It is about what this connection is told.");
    private static final StreamAccessRule PING = new StreamAccessRule.StreamOnly(
            AccessLevel.VIEWER, RequestCost.REQUEST, AuditPolicy.LEFT_OUT, "It asks whether this connection stands.");

    private final RestOperations operations;

    StreamAccessRules(RestOperations operations) {
        this.operations = operations;
    }

    AccessRule rule(StreamRequest request) {
        return of(request.kind()).of(request, operations::rule);
    }

    public static StreamAccessRule of(StreamRequestKind kind) {
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
