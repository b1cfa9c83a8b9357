package org.dronemap.ws.soap;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import javax.xml.namespace.QName;
import org.apache.cxf.message.Exchange;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.AbstractPhaseInterceptor;
import org.apache.cxf.phase.Phase;
import org.dronemap.core.audit.Activity;
import org.dronemap.ws.service.AuditNotes;
import org.dronemap.ws.service.AuditRules;
import org.jspecify.annotations.Nullable;

/** Notes which operation a call is of, and of which drone, for the record that it leaves. */
final class NamedCalls extends AbstractPhaseInterceptor<Message> {
    /** The first value of these is no drone's id. */
    private static final Map<String, String> OF_OTHER_THINGS = Map.ofEntries(
            Map.entry("acceptPlan", MAVLinkController.PLAN_ID),
            Map.entry("stopPlan", MAVLinkController.PLAN_ID),
            Map.entry("cancelPlan", MAVLinkController.PLAN_ID),
            Map.entry("startRun", MAVLinkController.PLAN_ID),
            Map.entry("addRunWaypoint", MAVLinkController.RUN_ID),
            Map.entry("resumeRunDrone", MAVLinkController.RUN_ID),
            Map.entry("answerRun", MAVLinkController.RUN_ID),
            Map.entry("pauseRun", MAVLinkController.RUN_ID),
            Map.entry("continueRun", MAVLinkController.RUN_ID),
            Map.entry("stopRun", MAVLinkController.RUN_ID),
            Map.entry("cancelFollowRequest", Follower.FOLLOW_ID),
            Map.entry("startTracking", Follower.FOLLOW_ID),
            Map.entry("sendNewGPSLocation", Follower.FOLLOW_ID),
            Map.entry("disableTracking", Follower.FOLLOW_ID),
            Map.entry("enableTracking", Follower.FOLLOW_ID),
            Map.entry("stopTracking", Follower.FOLLOW_ID),
            Map.entry("issueRobotKey", MAVLinkController.ROBOT_KEY_ID),
            Map.entry("revokeRobotKey", MAVLinkController.ROBOT_KEY_ID),
            Map.entry("createVirtualDrone", "name"),
            Map.entry("startVirtualDrone", MAVLinkController.VIRTUAL_ID),
            Map.entry("stopVirtualDrone", MAVLinkController.VIRTUAL_ID),
            Map.entry("resumeVirtualDrone", MAVLinkController.VIRTUAL_ID),
            Map.entry("removeVirtualDrone", MAVLinkController.VIRTUAL_ID));

    NamedCalls() {
        super(Phase.PRE_INVOKE);
    }

    @Override
    public void handleMessage(Message message) {
        Exchange exchange = message.getExchange();
        note(exchange);
        List<?> arguments = message.getContent(List.class);
        if (arguments != null) {
            String operation = exchange.getBindingOperationInfo() == null
                    ? ""
                    : exchange.getBindingOperationInfo().getName().getLocalPart();
            Activity.current().ifPresent(call -> note(call, OF_OTHER_THINGS.get(operation), arguments));
        }
    }

    /** What is known of it so far. */
    static void note(Exchange exchange) {
        if (exchange.getBindingOperationInfo() != null) {
            QName name = exchange.getBindingOperationInfo().getName();
            Activity.current().ifPresent(call -> {
                call.operation(name.getLocalPart());
                if (AuditRules.leavesOutSoap(name.getLocalPart())) {
                    call.leaveOut();
                } else if (AuditRules.recordsElsewhere(name.getLocalPart())) {
                    call.leaveOutUnlessTurnedAway();
                }
            });
        }
    }

    /** Most operations that change something are of one drone; of the rest only what are plain values. */
    private static void note(Activity call, @Nullable String first, List<?> arguments) {
        for (int i = 0; i < arguments.size(); i++) {
            Object value = arguments.get(i);
            if (i == 0 && value instanceof String thing) {
                if (first == null) {
                    call.drone(AuditNotes.told(thing));
                } else {
                    call.parameters(first + "=" + AuditNotes.told(thing));
                }
            } else if (value instanceof List<?> drones && drones.stream().allMatch(String.class::isInstance)) {
                String told = drones.stream().map(String::valueOf).collect(Collectors.joining(" "));
                call.parameters("drones=" + AuditNotes.told(told));
            } else if (value instanceof String text) {
                call.parameters(AuditNotes.told(text), "");
            } else if (value instanceof Number || value instanceof Boolean) {
                call.parameters(value.toString());
            }
        }
    }
}
