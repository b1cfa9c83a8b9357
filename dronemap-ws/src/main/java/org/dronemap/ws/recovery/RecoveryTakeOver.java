package org.dronemap.ws.recovery;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.dronemap.cognitive.operation.recovery.RecoveryManner;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.ws.operation.OperationEnding;
import org.dronemap.ws.problem.Rejection;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Frees the drones of a recovery from whoever has them, where that was asked for and is allowed. Any thread. */
final class RecoveryTakeOver {
    private static final Logger LOG = LoggerFactory.getLogger(RecoveryTakeOver.class);

    private final CloudManager cloud;
    private final List<OperationEnding> endings;

    RecoveryTakeOver(CloudManager cloud, List<OperationEnding> endings) {
        this.cloud = cloud;
        this.endings = List.copyOf(endings);
    }

    /** Each operation loses its drones first, so that it does not command them when it ends. */
    void free(Principal principal, RecoveryManner manner, List<DroneState> drones) {
        String why = principal.name() + " brings it " + (manner == RecoveryManner.LAND ? "down." : "home.");
        Set<String> ended = new LinkedHashSet<>();
        for (DroneState drone : drones) {
            Lease tenure = cloud.controls().control(drone.id()).tenure();
            if (tenure == null || tenure.holder().is(principal.name())) {
                continue;
            }
            if (tenure.holder() instanceof LeaseHolder.Operation operation) {
                ended.add(operation.id());
                cloud.controls().apply(drone.id(), new LeaseEvent.Interrupt(why));
            } else {
                cloud.controls().apply(drone.id(), new LeaseEvent.TakeOver(principal.name(), why));
                cloud.controls().apply(drone.id(), new LeaseEvent.Release(principal.name()));
            }
        }
        ended.forEach(id -> endings.forEach(ending -> end(ending, principal, id)));
    }

    /** Its drones are free already: that it goes on without them, or is over by now, is no reason to leave them in the air. */
    private static void end(OperationEnding ending, Principal principal, String id) {
        try {
            ending.end(principal, id);
        } catch (Rejection refused) {
            LOG.debug("The operation {} was not ended: {}", id, refused.sentence());
        }
    }
}
