package org.dronemap.ws.stream;

import java.util.Set;
import org.dronemap.core.audit.Activity;
import org.dronemap.ws.service.AuditNotes;
import org.dronemap.ws.service.AuditRules;

/** Notes what a client says, for the record that it leaves. */
final class StreamNotes {
    /** Anything else stays unreadable: it may be a secret in the wrong place. */
    private static final Set<String> TYPES =
            Set.of("authenticate", "command", "control", "steer", "letGo", "positions", "subscribe", "ping");

    private static final String CONTROL = "control";
    private static final String HEARTBEAT = "heartbeat";

    private StreamNotes() {}

    static void note(String type, StreamMessage.FromClient message) {
        Activity.current().ifPresent(call -> note(call, type, message));
    }

    private static void note(Activity call, String type, StreamMessage.FromClient message) {
        if (TYPES.contains(type)) {
            call.operation(type);
        }
        if (AuditRules.leavesOutStream(type) || (type.equals(CONTROL) && HEARTBEAT.equals(message.action()))) {
            call.leaveOut();
        } else if (AuditRules.recordsElsewhere(type)) {
            call.leaveOutUnlessTurnedAway();
        }
        String drone = message.drone();
        if (drone != null) {
            call.drone(AuditNotes.told(drone));
        }
        if (type.equals(CONTROL)) {
            call.parameters(
                    AuditNotes.summaryOf(
                            "action", message.action(), "user", message.user(), "reason", message.reason()),
                    "");
        }
        if (message.command() != null) {
            AuditNotes.sent(message.command());
        }
    }
}
