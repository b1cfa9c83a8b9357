package org.dronemap.ws.stream;

import org.dronemap.core.audit.Activity;
import org.dronemap.ws.service.AuditNotes;
import org.dronemap.ws.service.AuditRules;

/** Notes what a client says, for the record that it leaves. */
final class StreamNotes {
    private static final String HEARTBEAT = "heartbeat";

    private StreamNotes() {}

    static void note(StreamRequest request) {
        Activity.current().ifPresent(call -> note(call, request));
    }

    private static void note(Activity call, StreamRequest request) {
        String type = request.kind().word();
        call.operation(type);
        String drone = request.drone();
        if (drone != null) {
            call.drone(AuditNotes.told(drone));
        }
        if (request instanceof StreamRequest.GiveCommand given && given.command() != null) {
            AuditNotes.sent(given.command());
        }
        if (request instanceof StreamRequest.ActOnControl control) {
            call.parameters(
                    AuditNotes.summaryOf(
                            "action", control.action(), "user", control.user(), "reason", control.reason()),
                    "");
        }
        if (AuditRules.leavesOutStream(type)
                || (request instanceof StreamRequest.ActOnControl control && HEARTBEAT.equals(control.action()))) {
            call.leaveOut();
        } else if (AuditRules.recordsElsewhere(type)) {
            call.leaveOutUnlessTurnedAway();
        }
    }
}
