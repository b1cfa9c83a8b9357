package org.dronemap.ws.stream;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.audit.Activity;
import org.dronemap.core.audit.AuditDesk;
import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.security.Authentication;
import org.dronemap.ws.security.SignedIn;
import org.dronemap.ws.service.AuditNotes;
import org.dronemap.ws.service.Budgets;
import org.dronemap.ws.service.CommandRequest;
import org.dronemap.ws.service.CommandService;
import org.dronemap.ws.service.DroneService;
import org.dronemap.ws.service.DroneView;
import org.dronemap.ws.service.FollowReceipt;
import org.dronemap.ws.service.FollowRequest;
import org.dronemap.ws.service.FollowService;
import org.dronemap.ws.service.InvalidInput;
import org.dronemap.ws.service.JsonReader;
import org.dronemap.ws.service.Outages;
import org.dronemap.ws.service.Problem;
import org.dronemap.ws.service.Rejection;
import org.dronemap.ws.service.RejectionKind;
import org.dronemap.ws.service.Roles;
import org.dronemap.ws.service.WireNames;
import org.dronemap.ws.service.Work;
import org.java_websocket.framing.CloseFrame;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Answers what clients of the stream say. Any thread. */
final class StreamRequests {
    private static final Logger LOG = LoggerFactory.getLogger(StreamRequests.class);
    private static final String TYPES = "authenticate, command, control, steer, letGo, positions, subscribe or ping";

    /** Of these some cost nothing, as they are for safety. */
    private static final Set<String> PAID_ELSEWHERE = Set.of("command", "control", "steer", "letGo");

    private final Authentication authentication;
    private final Budgets budgets;
    private final DroneService drones;
    private final CommandService commands;
    private final StreamControl controls;
    private final StreamSteering steering;
    private final FollowService follows;
    private final StreamPhones phones;
    private final StreamCrowd crowd;
    private final JsonReader json;
    private final AuditDesk desk;

    StreamRequests(StreamFace.Services services, StreamPhones phones) {
        this.authentication = services.entrance().authentication();
        this.budgets = services.entrance().bounds().budgets();
        this.drones = services.drones();
        this.commands = services.commands();
        this.controls = new StreamControl(services.reins().controls());
        this.steering = new StreamSteering(services.reins().steering());
        this.phones = phones;
        this.follows = services.pictures().follows();
        this.crowd = services.entrance().bounds().crowd();
        this.json = services.json();
        this.desk = services.entrance().desk();
    }

    /** Lets a client in, with the whole list first. */
    void welcome(StreamClient client, SignedIn proved) {
        // First admitted, then judged: whatever is revoked from here on finds the client among those admitted.
        try {
            crowd.admit(client, proved);
            SignedIn caller = authentication.still(proved).orElseThrow(Rejection::sessionEnded);
            authentication.admit(caller);
            Principal principal = caller.principal();
            say(client, new StreamMessage.Hello(principal.name(), WireNames.camel(principal.role())));
            List<DroneView> all = drones.drones(principal);
            all.forEach(drone -> {
                DroneId id = new DroneId(drone.id());
                Object sight = Topics.sightOf(principal, id);
                if (sight != null) {
                    client.shown().put(Subject.drone(id), sight);
                }
            });
            say(client, new StreamMessage.Drones(all));
            client.unsettle();
        } catch (Rejection rejection) {
            boolean later = rejection.kind() == RejectionKind.THROTTLED;
            expel(client, later ? CloseFrame.TRY_AGAIN_LATER : CloseFrame.POLICY_VALIDATION, rejection);
        }
    }

    /** What a client may is judged anew; it has to leave when that has become less, or other. */
    void judgeAnew(StreamClient client, SignedIn before) {
        try {
            Optional<SignedIn> now = authentication.still(before);
            if (now.isEmpty()) {
                expel(client, CloseFrame.POLICY_VALIDATION, Rejection.sessionEnded());
            } else if (!now.get().principal().equals(before.principal())) {
                expel(client, CloseFrame.TRY_AGAIN_LATER, Rejection.forbidden("Your role was changed; connect again."));
            }
        } catch (RuntimeException e) {
            // Who cannot be judged cannot stay.
            LOG.error("The rights of {} are not known", before.principal().name(), e);
            expel(
                    client,
                    CloseFrame.TRY_AGAIN_LATER,
                    new Rejection(RejectionKind.UNAVAILABLE, "Your rights are not known; try again."));
        }
    }

    void expel(StreamClient client, int code, Rejection why) {
        String message = json.write(new StreamMessage.Failure(Problem.of(why), null));
        client.expel(new StreamClient.Farewell(code, why.sentence(), message));
        steering.handsOff(client);
    }

    /** Its connection has ended. */
    void left(StreamClient client, int code, boolean remote) {
        client.leave();
        steering.handsOff(client);
        phones.left(client, code, remote, System.nanoTime());
    }

    void hear(StreamClient client, String text) {
        Activity call = desk.begin("stream", "unreadable");
        client.principal().ifPresent(call::by);
        call.during(() -> {
            heard(client, text);
            return true;
        });
        desk.end(call);
    }

    /** Whoever comes with a proof that is none leaves a record, as with one that is said later. */
    void refused(Rejection rejection) {
        Activity call = desk.begin("stream", "authenticate");
        call.during(() -> {
            AuditNotes.turnedAway(Problem.of(rejection));
            return true;
        });
        desk.end(call);
    }

    private void heard(StreamClient client, String text) {
        String requestId = null;
        try {
            StreamMessage.FromClient message = json.read(text, StreamMessage.FromClient.class);
            requestId = message.requestId();
            answer(client, message);
        } catch (Rejection rejection) {
            AuditNotes.turnedAway(Problem.of(rejection));
            if (client.principal().isEmpty()) {
                expel(client, CloseFrame.POLICY_VALIDATION, rejection);
            } else {
                say(client, new StreamMessage.Failure(Problem.of(rejection), requestId));
            }
        } catch (RuntimeException e) {
            Problem problem = problem(e);
            AuditNotes.turnedAway(problem);
            say(client, new StreamMessage.Failure(problem, requestId));
        }
    }

    private static Problem problem(RuntimeException failure) {
        Rejection outage = Outages.of(failure).orElse(null);
        if (outage != null) {
            LOG.warn("A message came while the store was away: {}", String.valueOf(failure.getMessage()));
            return Problem.of(outage);
        }
        LOG.error("A message of the stream failed", failure);
        return Problem.internal();
    }

    private void answer(StreamClient client, StreamMessage.FromClient message) {
        String type = message.type();
        if (type == null) {
            throw InvalidInput.missing("type", TYPES);
        }
        StreamNotes.note(type, message);
        if (type.equals("authenticate")) {
            authenticate(client, message.key());
            return;
        }
        Principal principal = client.principal()
                .orElseThrow(() -> Rejection.notSignedIn(
                        "Send {\"type\":\"authenticate\",\"key\":\"…\"} with an access key first."));
        if (!PAID_ELSEWHERE.contains(type)) {
            budgets.take(Work.REQUEST, principal.name());
        }
        switch (type) {
            case "command" -> command(client, principal, message);
            case "control" -> say(client, controls.answer(principal, message));
            case "steer" -> steer(client, message);
            case "letGo" -> steering.letGo(client, principal, message);
            case "positions" -> say(client, positions(client, principal, message));
            case "subscribe" -> subscribe(client, message);
            case "ping" -> say(client, new StreamMessage.Pong());
            default -> throw InvalidInput.outside("type", TYPES, "\"" + type + "\"");
        }
    }

    /** What the gate refuses it writes down itself; what is refused again and again leaves no more records than sentences. */
    private void steer(StreamClient client, StreamMessage.FromClient message) {
        try {
            if (steering.steer(client, message)) {
                return;
            }
        } catch (Rejection why) {
            if (why.kind() != RejectionKind.CONFLICT) {
                throw why;
            }
            say(client, new StreamMessage.Failure(Problem.of(why), message.requestId()));
        }
        Activity.current().ifPresent(Activity::leaveOut);
    }

    private StreamMessage.PositionsHeard positions(
            StreamClient client, Principal principal, StreamMessage.FromClient message) {
        Roles.require(principal, Role.OPERATOR);
        String follow = message.follow();
        if (follow == null) {
            throw InvalidInput.missing("follow", "the id of a follow");
        }
        FollowRequest.PositionsRequest said =
                new FollowRequest.PositionsRequest(message.sent(), message.roundTrip(), message.positions());
        FollowReceipt receipt = follows.positions(principal, follow, said);
        phones.spoke(client, receipt.follow(), System.nanoTime());
        return new StreamMessage.PositionsHeard(message.requestId(), receipt);
    }

    private static void subscribe(StreamClient client, StreamMessage.FromClient message) {
        slowDown(client, message.rate());
        client.subscribe(message.drones());
    }

    /** Null leaves it as it is. */
    static void slowDown(StreamClient client, @Nullable Integer rate) {
        if (rate == null) {
            return;
        }
        if (rate < 1 || rate > Turns.MOST_PER_SECOND) {
            throw InvalidInput.outside("rate", "1 to " + Turns.MOST_PER_SECOND + " a second", rate);
        }
        client.slowDown(rate);
    }

    private void authenticate(StreamClient client, @Nullable String key) {
        if (key == null) {
            throw InvalidInput.missing("key", "an access key");
        }
        SignedIn caller = authentication.byKey(key);
        if (client.caller().isEmpty()) {
            welcome(client, caller);
        }
    }

    private void command(StreamClient client, Principal principal, StreamMessage.FromClient message) {
        String drone = message.drone();
        CommandRequest command = message.command();
        if (drone == null) {
            throw InvalidInput.missing("drone", "the id of a drone");
        }
        if (command == null) {
            throw InvalidInput.missing("command", "an object such as {\"type\":\"arm\"}");
        }
        say(
                client,
                new StreamMessage.CommandAccepted(
                        message.requestId(), commands.submit(principal, "stream", drone, command)));
    }

    void say(StreamClient client, StreamMessage message) {
        client.outbox().add(json.write(message));
    }
}
