package org.dronemap.ws.stream;

import org.dronemap.core.access.Principal;
import org.dronemap.ws.service.ControlAction;
import org.dronemap.ws.service.ControlRequestView;
import org.dronemap.ws.service.ControlService;
import org.dronemap.ws.service.InvalidInput;
import org.dronemap.ws.service.ValueProblem;

/** Answers what clients of the stream say about control. Any thread. */
final class StreamControl {
    private static final String ACTIONS = "take, request, grant, refuse, handOver, takeOver, heartbeat or release";

    private final ControlService controls;

    StreamControl(ControlService controls) {
        this.controls = controls;
    }

    StreamMessage.ControlAnswer answer(Principal principal, StreamRequest.ActOnControl request) {
        String drone = request.drone();
        if (drone == null) {
            throw InvalidInput.missing("drone", "the id of a drone");
        }
        ControlService.Answer answer = controls.act(
                principal,
                drone,
                action(request),
                new ControlRequestView(request.reason(), request.user(), request.epoch()));
        return new StreamMessage.ControlAnswer(request.requestId(), drone, answer.waiting(), answer.control());
    }

    static ControlAction action(StreamRequest.ActOnControl request) {
        String action = request.action();
        if (action == null) {
            throw InvalidInput.missing("action", ACTIONS);
        }
        return ControlAction.named(action)
                .orElseThrow(() ->
                        InvalidInput.outside(ValueProblem.VALUE_NOT_ALLOWED, "action", ACTIONS, "\"" + action + "\""));
    }
}
