package org.dronemap.ws.control;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.dronemap.core.access.Principal;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.ws.access.AuditNotes;
import org.dronemap.ws.drone.ControlView;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.dronemap.ws.stream.StreamAccessRule;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamOperation;
import org.dronemap.ws.stream.StreamRequest;
import org.dronemap.ws.stream.StreamRequestType;
import org.jspecify.annotations.Nullable;
import org.springframework.core.annotation.Order;
import tools.jackson.databind.annotation.JsonTypeResolver;

/** Handles requests of clients of the WebSocket stream about the control of a drone. Any thread. */
final class ControlStreamOperation {
    /** The operations of REST that do the same. */
    static final Map<ControlAction, String> BY_ACTION = Map.of(
            ControlAction.TAKE, "takeControl",
            ControlAction.REQUEST, "requestControl",
            ControlAction.GRANT, "grantControl",
            ControlAction.REFUSE, "refuseControl",
            ControlAction.HAND_OVER, "handOverControl",
            ControlAction.TAKE_OVER, "takeOverControl",
            ControlAction.HEARTBEAT, "keepControl",
            ControlAction.RELEASE, "releaseControl");

    /**
     * The name of requests about control among all requests of the stream. It does not stand at them themselves, as it would
     * count as a name of each action.
     */
    @JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
    @JsonTypeResolver(ObjectOnlyTypeResolver.class)
    @JsonSubTypes(@JsonSubTypes.Type(value = StreamControlRequest.class, name = "control"))
    sealed interface ControlRequestType extends StreamRequest.OfUseCase permits StreamControlRequest {}

    @JsonTypeName("controlAnswer")
    @Order(810)
    @Schema(
            name = "StreamControlAnswer",
            description = "Answers what was said about control; waiting: the holder was asked.")
    record ControlAnswer(@Nullable String requestId, String drone, boolean waiting, ControlView control)
            implements StreamMessage.OfUseCase {}

    private ControlStreamOperation() {}

    static StreamOperation<StreamControlRequest> of(ControlService controls) {
        return new StreamOperation<>(
                new StreamRequestType<>(
                        StreamControlRequest.class,
                        new StreamAccessRule.OfOneOf<>(
                                List.copyOf(BY_ACTION.values()),
                                request -> Objects.requireNonNull(
                                        BY_ACTION.get(request.asked().action()))),
                        ControlAnswer.class),
                ControlStreamOperation::note,
                (connection, principal, request) -> act(controls, principal, request));
    }

    private static void note(StreamControlRequest request) {
        AuditedCall.current()
                .ifPresent(call ->
                        call.parameters(AuditNotes.summaryOf("user", request.user(), "reason", request.reason()), ""));
    }

    private static ControlAnswer act(ControlService controls, Principal principal, StreamControlRequest request) {
        String drone = request.drone();
        if (drone == null) {
            throw InvalidInput.missing("drone", "the id of a drone");
        }
        ControlService.Answer answer = controls.act(principal, drone, request.asked());
        return new ControlAnswer(request.requestId(), drone, answer.waiting(), answer.control());
    }
}
