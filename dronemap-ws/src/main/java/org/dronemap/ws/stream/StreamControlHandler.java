package org.dronemap.ws.stream;

import org.dronemap.core.access.Principal;
import org.dronemap.ws.control.ControlService;
import org.dronemap.ws.problem.InvalidInput;

/** Handles requests of stream clients about the control of a drone. Any thread. */
final class StreamControlHandler {
    private final ControlService controls;

    StreamControlHandler(ControlService controls) {
        this.controls = controls;
    }

    StreamMessage.ControlAnswer answer(Principal principal, StreamControlRequest request) {
        String drone = request.drone();
        if (drone == null) {
            throw InvalidInput.missing("drone", "the id of a drone");
        }
        ControlService.Answer answer = controls.act(principal, drone, request.asked());
        return new StreamMessage.ControlAnswer(request.requestId(), drone, answer.waiting(), answer.control());
    }
}
