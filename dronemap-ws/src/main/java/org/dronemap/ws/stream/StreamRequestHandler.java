package org.dronemap.ws.stream;

import com.fasterxml.jackson.annotation.JsonIgnoreProperties;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.audit.AuditRecorder;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.ws.access.AccessRule;
import org.dronemap.ws.access.AuditNotes;
import org.dronemap.ws.access.RestOperation;
import org.dronemap.ws.access.RestOperations;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.budget.Budgets;
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
import org.java_websocket.framing.CloseFrame;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Handles requests of clients of the WebSocket stream: checks access, carries them out and answers. Any thread. */
final class StreamRequestHandler {
    private static final Logger LOG = LoggerFactory.getLogger(StreamRequestHandler.class);

    private final CallerAuthenticator authentication;
    private final Budgets budgets;
    private final RestOperations operations;
    private final StreamRequestCatalogue requests;
    private final RecordAlternatives types;
    private final List<StreamWelcome> welcomes;
    private final List<StreamConnectionListener> listeners;
    private final StreamClientRegistry crowd;
    private final JsonCodec json;
    private final JsonCodec reader;
    private final AuditRecorder desk;
    private final String version;

    /** Fields of a request that are read before its type is known, so that an error response can name the request. */
    @JsonIgnoreProperties(ignoreUnknown = true)
    record Head(@Nullable String type, @Nullable String requestId) {}

    StreamRequestHandler(StreamFace.Services services, StreamRequestCatalogue requests) {
        this.authentication = services.entrance().authentication();
        this.budgets = services.entrance().bounds().budgets();
        this.operations = services.entrance().bounds().operations();
        this.requests = requests;
        this.types = requests.alternatives();
        this.welcomes = services.features().welcomes();
        this.listeners = services.features().listeners();
        this.crowd = services.entrance().bounds().crowd();
        this.json = services.json();
        this.reader = requests.reader(json);
        this.desk = services.entrance().audit();
        this.version = services.version();
    }

    /** Lets a client in, with what features tell it first. */
    void welcome(StreamClient client, AuthenticatedCaller proved) {
        // First admitted, then judged: whatever is revoked from here on finds the client among those admitted.
        try {
            crowd.admit(client, proved);
            AuthenticatedCaller caller = authentication.still(proved).orElseThrow(Rejection::sessionEnded);
            authentication.admit(caller);
            Principal principal = caller.principal();
            send(client, new StreamMessage.Hello(principal.name(), WireNames.camel(principal.role()), version));
            client.setGreeted();
            welcomes.forEach(welcome -> {
                StreamWelcome.Greeting first = welcome.greeting().apply(principal);
                client.shown().putAll(first.sights());
                send(client, first.message());
            });
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
        listeners.forEach(listener -> listener.left(client));
    }

    /** Its connection has ended. */
    void disconnected(StreamClient client, int code, boolean remote) {
        client.leave();
        listeners.forEach(listener -> listener.left(client));
        StreamEnding ending = StreamEnding.of(code, remote);
        listeners.forEach(listener -> listener.disconnected(client, ending));
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
            answer(client, reader.read(text, StreamRequest.class));
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

    private void requireType(@Nullable String type) {
        if (type == null) {
            throw InvalidInput.missing(types.member(), types.allowed());
        }
        if (!types.records().containsKey(type)) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_NOT_ALLOWED, types.member(), types.allowed(), "\"" + type + "\"");
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
        AccessRule rule = rule(request);
        StreamAuditNotes.note(nameInRecord(rule, request), request);
        Optional<StreamOperation<?>> ofFeature = requests.operation(request);
        ofFeature.ifPresent(operation -> operation.note(request));
        if (request instanceof StreamRequest.Authenticate proof) {
            StreamAuditNotes.note(rule.audit());
            authenticate(client, proof.key());
            return;
        }
        Principal principal = client.principal()
                .orElseThrow(() -> Rejection.of(
                        AccessProblem.SIGN_IN_NEEDED,
                        "Send {\"type\":\"authenticate\",\"key\":\"…\"} with an access key first."));
        judge(principal, rule);
        if (request instanceof StreamRequest.Subscribe subscription) {
            subscribe(client, subscription);
        } else if (request instanceof StreamRequest.Ping) {
            send(client, new StreamMessage.Pong());
        } else {
            StreamMessage answer = ofFeature.orElseThrow().handle(client, principal, request);
            if (answer != null) {
                send(client, answer);
            }
        }
    }

    /** What REST can do as well has the same name in the record, whichever face does it. */
    private String nameInRecord(AccessRule rule, StreamRequest request) {
        RestOperation operation = rule.operation();
        return operation == null ? requests.nameOf(request) : operation.name();
    }

    private AccessRule rule(StreamRequest request) {
        return requests.typeOf(request).rule(request, operations::rule);
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

    void send(StreamClient client, StreamMessage message) {
        client.outbox().add(json.write(message));
    }
}
