package org.dronemap.ws.control;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import org.dronemap.core.access.Principal;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.AuditPolicy;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.dronemap.ws.stream.StreamAccessRule;
import org.dronemap.ws.stream.StreamConnection;
import org.dronemap.ws.stream.StreamConnectionListener;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamOperation;
import org.dronemap.ws.stream.StreamRequest;
import org.dronemap.ws.stream.StreamRequestType;
import org.jspecify.annotations.Nullable;

/**
 * Passes steering requests of clients of the WebSocket stream to the steering service, and lets go of drones when a client
 * leaves. Any thread; for one client one at a time, so that nothing is steered by rights that have ended in between.
 */
final class SteeringStreamOperations implements StreamConnectionListener {
    private static final String FACE = "stream";
    private static final String DRONE = "the id of a drone";

    private final SteeringService steering;

    @JsonTypeName("steer")
    @Schema(name = "StreamSteerRequest", description = "Steers for half a second, by speeds or by sticks.")
    record Steer(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a drone") @Nullable
            String drone,

            SteeringRequest.@Nullable Velocity velocity,
            SteeringRequest.@Nullable Sticks sticks,

            @Schema(description = "It counts under that control only") @Nullable
            Long epoch)
            implements StreamRequest.OfUseCase {}

    @JsonTypeName("letGo")
    @Schema(name = "StreamLetGoRequest", description = "Ends what was steered: the vehicle stands still at once.")
    record LetGo(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a drone") @Nullable
            String drone)
            implements StreamRequest.OfUseCase {}

    SteeringStreamOperations(SteeringService steering) {
        this.steering = steering;
    }

    StreamOperation<Steer> steering() {
        return StreamOperation.of(
                new StreamRequestType<>(
                        Steer.class,
                        new StreamAccessRule.StreamOnly<>(
                                AccessLevel.VIEWER,
                                RequestCost.NOTHING,
                                AuditPolicy.REFUSALS_ONLY,
                                "Setpoints come many times a second; role and budget are judged where the same refusal is"
                                        + " told once in one."),
                        null),
                (connection, principal, request) -> steer(connection, request));
    }

    StreamOperation<LetGo> lettingGo() {
        return StreamOperation.of(
                new StreamRequestType<>(
                        LetGo.class,
                        new StreamAccessRule.StreamOnly<>(
                                AccessLevel.OPERATOR,
                                RequestCost.NOTHING,
                                AuditPolicy.REFUSALS_ONLY,
                                "It ends what is steered, which REST cannot do."),
                        null),
                (connection, principal, request) -> {
                    letGo(connection, principal, request);
                    return null;
                });
    }

    /** What the gate refuses it writes down itself; what is refused again and again leaves no more records than sentences. */
    private StreamMessage.@Nullable Failure steer(StreamConnection connection, Steer request) {
        StreamMessage.Failure refusal = null;
        try {
            if (applied(connection, request)) {
                return null;
            }
        } catch (Rejection why) {
            if (why.kind() != RejectionKind.CONFLICT) {
                throw why;
            }
            refusal = new StreamMessage.Failure(ProblemView.of(why), request.requestId());
        }
        AuditedCall.current().ifPresent(AuditedCall::leaveOut);
        return refusal;
    }

    /** False when it was not applied, and its client has just been told why; throws when it is to be told. */
    private boolean applied(StreamConnection connection, Steer request) {
        String drone = request.drone();
        if (drone == null) {
            throw InvalidInput.missing("drone", DRONE);
        }
        SteeredDrones steered = steered(connection);
        synchronized (steered) {
            // Asked for here: who was shown out meanwhile has none.
            Principal principal = connection.principal().orElseThrow(Rejection::sessionEnded);
            try {
                steering.steer(
                        principal,
                        FACE,
                        drone,
                        new SteeringRequest(request.velocity(), request.sticks(), request.epoch()));
                steered.add(drone, principal);
                return true;
            } catch (Rejection why) {
                letGo(steered, drone);
                if (steered.mayNotify(drone, why.sentence(), connection.nowNanos())) {
                    throw why;
                }
                return false;
            }
        }
    }

    private void letGo(StreamConnection connection, Principal principal, LetGo request) {
        String drone = request.drone();
        if (drone == null) {
            throw InvalidInput.missing("drone", DRONE);
        }
        SteeredDrones steered = steered(connection);
        synchronized (steered) {
            if (!letGo(steered, drone)) {
                steering.require(principal, drone);
            }
        }
    }

    /** All that it steers stands still; nothing that it says from now on is applied, as it is nobody any more. */
    @Override
    public void left(StreamConnection connection) {
        SteeredDrones steered = steered(connection);
        synchronized (steered) {
            steered.drones().forEach(drone -> letGo(steered, drone));
        }
    }

    private boolean letGo(SteeredDrones steered, String drone) {
        Principal principal = steered.remove(drone);
        if (principal == null) {
            return false;
        }
        steering.letGo(principal, FACE, drone);
        return true;
    }

    private static SteeredDrones steered(StreamConnection connection) {
        return connection.attachment(SteeredDrones.class, SteeredDrones::new);
    }
}
