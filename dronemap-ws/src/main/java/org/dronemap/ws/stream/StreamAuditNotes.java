package org.dronemap.ws.stream;

import org.dronemap.core.audit.AuditedCall;
import org.dronemap.ws.access.AuditNotes;
import org.dronemap.ws.access.AuditPolicy;
import org.dronemap.ws.reading.WireNames;

/** Adds details of a stream client's request to its audit record. */
final class StreamAuditNotes {

    private StreamAuditNotes() {}

    /** It leaves the record that its rule says. */
    static void note(AuditPolicy audit) {
        AuditedCall.current().ifPresent(call -> {
            switch (audit) {
                case REFUSALS_ONLY -> call.leaveOutUnlessTurnedAway();
                case LEFT_OUT, ONLY_LOOKS -> call.leaveOut();
                case BY_METHOD, RECORDED, RECORDED_WITH_PLACE -> {}
            }
        });
    }

    static void note(StreamRequest request) {
        AuditedCall.current().ifPresent(call -> note(call, request));
    }

    private static void note(AuditedCall call, StreamRequest request) {
        call.operation(request.kind().word());
        String drone = request.drone();
        if (drone != null) {
            call.drone(AuditNotes.withoutSecrets(drone));
        }
        if (request instanceof StreamRequest.GiveCommand given && given.command() != null) {
            AuditNotes.sent(given.command());
        }
        if (request instanceof StreamControlRequest control) {
            String action = WireNames.camel(control.asked().action());
            call.parameters(
                    AuditNotes.summaryOf("action", action, "user", control.user(), "reason", control.reason()), "");
        }
    }
}
