package org.dronemap.ws.stream;

import org.dronemap.core.audit.AuditedCall;
import org.dronemap.ws.access.AuditNotes;
import org.dronemap.ws.access.AuditPolicy;

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

    /** {@code operation}: the name in the record. */
    static void note(String operation, StreamRequest request) {
        AuditedCall.current().ifPresent(call -> {
            call.operation(operation);
            String drone = request.drone();
            if (drone != null) {
                call.drone(AuditNotes.withoutSecrets(drone));
            }
        });
    }
}
