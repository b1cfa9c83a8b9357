package org.dronemap.ws.server;

import org.dronemap.core.access.Principal;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditRecorder;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.LeaseAnswer;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseStep;
import org.dronemap.proxy.outlet.uplink.OutletLeaseAuthority;

/** Carries out and audits requests for control of drones that come from ground stations at the outlet. Any thread. */
record AuditedOutletControl(CloudManager cloud, AuditRecorder recorder) implements OutletLeaseAuthority {
    private static final String FACE = "outlet";

    @Override
    public LeaseStep act(Principal by, DroneId drone, LeaseEvent event) {
        AuditedCall activity = recorder.begin(FACE, operation(event));
        activity.by(by);
        activity.drone(drone.value());
        try {
            LeaseStep step = activity.during(() -> cloud.controls().apply(drone, event));
            if (step.answer() instanceof LeaseAnswer.Denied denied) {
                activity.turnedAway(AuditOutcome.REFUSED, denied.why());
            }
            return step;
        } catch (RuntimeException e) {
            activity.turnedAway(AuditOutcome.FAILED, "The server could not do it.");
            throw e;
        } finally {
            recorder.end(activity);
        }
    }

    private static String operation(LeaseEvent event) {
        if (event instanceof LeaseEvent.Release) {
            return "giveControlBack";
        }
        if (event instanceof LeaseEvent.Grant) {
            return "handControlOver";
        }
        return event instanceof LeaseEvent.TakeControl ? "takeControl" : "requestControl";
    }
}
