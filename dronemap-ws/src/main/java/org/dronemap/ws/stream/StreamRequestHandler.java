package org.dronemap.ws.stream;

import com.fasterxml.jackson.annotation.JsonIgnoreProperties;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.audit.AuditRecorder;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.access.AccessRule;
import org.dronemap.ws.access.AuditNotes;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.budget.Budgets;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.command.CommandService;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.drone.DroneView;
import org.dronemap.ws.follow.FollowReceipt;
import org.dronemap.ws.follow.FollowRequest;
import org.dronemap.ws.follow.FollowService;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.OutageClassifier;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.reading.RecordAlternatives;
import org.dronemap.ws.reading.WireNames;
import org.dronemap.ws.security.AuthenticatedCaller;
import org.dronemap.ws.security.CallerAuthenticator;
import org.dronemap.ws.stream.delivery.PublishSchedule;
import org.dronemap.ws.stream.delivery.StreamMessageSubject;
import org.java_websocket.framing.CloseFrame;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Handles requests of clients of the WebSocket stream: checks access, carries them out and answers. Any thread. */
final class StreamRequestHandler {
    private static final Logger LOG = LoggerFactory.getLogger(StreamRequestHandler.class);
    private static final RecordAlternatives TYPES =
            RecordAlternatives.of(StreamRequest.class).orElseThrow();

    private final CallerAuthenticator authentication;
    private final Budgets budgets;
    private final StreamAccessRules rules;
    private final DroneService drones;
    private final CommandService commands;
    private final StreamControlHandler controls;
    private final StreamSteeringHandler steering;
    private final FollowService follows;
    private final PhoneReachability phones;
    private final StreamClientRegistry crowd;
    private final JsonCodec json;
    private final AuditRecorder desk;

    /** Fields of a request that are read before its type is known, so that an error response can name the request. */
    @JsonIgnoreProperties(ignoreUnknown = true)
    record Head(@Nullable String type, @Nullable String requestId) {}

    StreamRequestHandler(StreamFace.Services services, PhoneReachability phones) {
        this.authentication = services.entrance().authentication();
        this.budgets = services.entrance().bounds().budgets();
        this.rules = new StreamAccessRules(services.entrance().bounds().operations());
        this.drones = services.drones();
        this.commands = services.commands();
        this.controls = new StreamControlHandler(services.control().controls());
        this.steering = new StreamSteeringHandler(services.control().steering());
        this.phones = phones;
        this.follows = services.pictures().follows();
        this.crowd = services.entrance().bounds().crowd();
        this.json = services.json();
        this.desk = services.entrance().audit();
    }

    /** Lets a client in, with the whole list first. */
    void welcome(StreamClient client, AuthenticatedCaller proved) {
        // First admitted, then judged: whatever is revoked from here on finds the client among those admitted.
        try {
            crowd.admit(client, proved);
            AuthenticatedCaller caller = authentication.still(proved).orElseThrow(Rejection::sessionEnded);
            authentication.admit(caller);
            Principal principal = caller.principal();
            send(client, new StreamMessage.Hello(principal.name(), WireNames.camel(principal.role())));
            List<DroneView> all = drones.drones(principal);
            all.forEach(drone -> {
                DroneId id = new DroneId(drone.id());
                Object sight = StreamTopics.sightOf(principal, id);
                if (sight != null) {
                    client.shown().put(StreamMessageSubject.drone(id), sight);
                }
            });
            send(client, new StreamMessage.Drones(all));
            client.unsettle();
        } catch (Rejection rejection) {
            boolean later = rejection.kind() == RejectionKind.THROTTLED;
            expel(client, later ? CloseFrame.TRY_AGAIN_LATER : CloseFrame.POLICY_VALIDATION, rejection);
        }
    }

    /** What a client may is judged anew; it has to leave when that has become less, or other. */
    void reauthorize(StreamClient client, AuthenticatedCaller before) {
        try {
            Optional<AuthenticatedCaller> now = authentication.still(before);
            if (now.isEmpty()) {
                expel(client, CloseFrame.POLICY_VALIDATION, Rejection.sessionEnded());
            } else if (!now.get().principal().equals(before.principal())) {
                expel(
                        client,
                        CloseFrame.TRY_AGAIN_LATER,
                        Rejection.of(AccessProblem.ROLE_CHANGED, "Your role was changed; connect again."));
            }
        } catch (RuntimeException e) {
            // Who cannot be judged cannot stay.
            LOG.error("The rights of {} are not known", before.principal().name(), e);
            expel(
                    client,
                    CloseFrame.TRY_AGAIN_LATER,
                    Rejection.of(ServerProblem.RIGHTS_NOT_KNOWN, "Your rights are not known; try again."));
        }
    }

    void expel(StreamClient client, int code, Rejection why) {
        String message = json.write(new StreamMessage.Failure(ProblemView.of(why), null));
        client.expel(new StreamClient.ClosingMessage(code, why.sentence(), message));
        steering.stopSteering(client);
    }

    /** Its connection has ended. */
    void disconnected(StreamClient client, int code, boolean remote) {
        client.leave();
        steering.stopSteering(client);
        phones.disconnected(client, code, remote, System.nanoTime());
    }

    void received(StreamClient client, String text) {
        AuditedCall call = desk.begin("stream", "unreadable");
        client.principal().ifPresent(call::by);
        call.during(() -> {
            handle(client, text);
            return true;
        });
        desk.end(call);
    }

    /** Whoever comes with a proof that is none leaves a record, as with one that is said later. */
    void refused(Rejection rejection) {
        AuditedCall call = desk.begin("stream", "authenticate");
        call.during(() -> {
            AuditNotes.turnedAway(ProblemView.of(rejection));
            return true;
        });
        desk.end(call);
    }

    private void handle(StreamClient client, String text) {
        String requestId = null;
        try {
            Head head = json.read(text, Head.class);
            requestId = head.requestId();
            requireType(head.type());
            answer(client, json.read(text, StreamRequest.class));
        } catch (Rejection rejection) {
            AuditNotes.turnedAway(ProblemView.of(rejection));
            if (client.principal().isEmpty()) {
                expel(client, CloseFrame.POLICY_VALIDATION, rejection);
            } else {
                // Of what cannot be read as a whole, who sent it still has to know which it was.
                String which = requestId == null ? json.text(text, "requestId").orElse(null) : requestId;
                send(client, new StreamMessage.Failure(ProblemView.of(rejection), which));
            }
        } catch (RuntimeException e) {
            ProblemView problem = problem(e);
            AuditNotes.turnedAway(problem);
            send(client, new StreamMessage.Failure(problem, requestId));
        }
    }

    private static ProblemView problem(RuntimeException failure) {
        Rejection outage = OutageClassifier.of(failure).orElse(null);
        if (outage != null) {
            LOG.warn("A message came while the store was away: {}", String.valueOf(failure.getMessage()));
            return ProblemView.of(outage);
        }
        LOG.error("A message of the stream failed", failure);
        return ProblemView.internal();
    }

    private static void requireType(@Nullable String type) {
        if (type == null) {
            throw InvalidInput.missing(TYPES.member(), TYPES.allowed());
        }
        if (!TYPES.records().containsKey(type)) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_NOT_ALLOWED, TYPES.member(), TYPES.allowed(), "\"" + type + "\"");
        }
    }

    /** As the filters do with a request to REST. */
    private void judge(Principal principal, AccessRule rule) {
        StreamAuditNotes.note(rule.audit());
        rule.costs().work().forEach(work -> budgets.charge(work, principal.name()));
        Role least = rule.from().role();
        if (least != null) {
            RoleChecks.requireRole(principal, least);
        }
    }

    private void answer(StreamClient client, StreamRequest request) {
        StreamAuditNotes.note(request);
        if (request instanceof StreamRequest.Authenticate proof) {
            StreamAuditNotes.note(rules.rule(request).audit());
            authenticate(client, proof.key());
            return;
        }
        Principal principal = client.principal()
                .orElseThrow(() -> Rejection.of(
                        AccessProblem.SIGN_IN_NEEDED,
                        "Send {\"type\":\"authenticate\",\"key\":\"…\"} with an access key first."));
        judge(principal, rules.rule(request));
        switch (request.kind()) {
            case AUTHENTICATE -> throw new IllegalStateException("It is authenticated before.");
            case COMMAND -> send(client, command(principal, (StreamRequest.GiveCommand) request));
            case CONTROL -> send(client, controls.answer(principal, (StreamControlRequest) request));
            case STEER -> steer(client, (StreamRequest.Steer) request);
            case LET_GO -> steering.letGo(client, principal, (StreamRequest.LetGo) request);
            case POSITIONS -> send(client, positions(client, principal, (StreamRequest.Positions) request));
            case SUBSCRIBE -> subscribe(client, (StreamRequest.Subscribe) request);
            case PING -> send(client, new StreamMessage.Pong());
        }
    }

    /** What the gate refuses it writes down itself; what is refused again and again leaves no more records than sentences. */
    private void steer(StreamClient client, StreamRequest.Steer request) {
        try {
            if (steering.steer(client, request)) {
                return;
            }
        } catch (Rejection why) {
            if (why.kind() != RejectionKind.CONFLICT) {
                throw why;
            }
            send(client, new StreamMessage.Failure(ProblemView.of(why), request.requestId()));
        }
        AuditedCall.current().ifPresent(AuditedCall::leaveOut);
    }

    private StreamMessage.PositionsReceived positions(
            StreamClient client, Principal principal, StreamRequest.Positions request) {
        String follow = request.follow();
        if (follow == null) {
            throw InvalidInput.missing("follow", "the id of a follow");
        }
        FollowRequest.PositionsRequest said =
                new FollowRequest.PositionsRequest(request.sent(), request.roundTrip(), request.positions());
        FollowReceipt receipt = follows.positions(principal, follow, said);
        phones.received(client, receipt.follow(), System.nanoTime());
        return new StreamMessage.PositionsReceived(request.requestId(), receipt);
    }

    private static void subscribe(StreamClient client, StreamRequest.Subscribe request) {
        slowDown(client, request.rate());
        client.subscribe(request.drones());
    }

    /** Null leaves it as it is. */
    static void slowDown(StreamClient client, @Nullable Integer rate) {
        if (rate == null) {
            return;
        }
        if (rate < 1 || rate > PublishSchedule.MOST_PER_SECOND) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    "rate",
                    "1 to " + PublishSchedule.MOST_PER_SECOND + " a second",
                    rate,
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(PublishSchedule.MOST_PER_SECOND),
                    ProblemParameter.UNIT.is("a second"));
        }
        client.slowDown(rate);
    }

    private void authenticate(StreamClient client, @Nullable String key) {
        if (key == null) {
            throw InvalidInput.missing("key", "an access key");
        }
        AuthenticatedCaller caller = authentication.byKey(key);
        if (client.caller().isEmpty()) {
            welcome(client, caller);
        }
    }

    private StreamMessage.CommandAccepted command(Principal principal, StreamRequest.GiveCommand request) {
        String drone = request.drone();
        CommandRequest command = request.command();
        if (drone == null) {
            throw InvalidInput.missing("drone", "the id of a drone");
        }
        if (command == null) {
            throw InvalidInput.missing("command", "an object such as {\"type\":\"arm\"}");
        }
        return new StreamMessage.CommandAccepted(
                request.requestId(), commands.submit(principal, "stream", drone, command));
    }

    void send(StreamClient client, StreamMessage message) {
        client.outbox().add(json.write(message));
    }
}
