package org.dronemap.core.lease;

import java.util.List;

/**
 * Result of one event for the lease machine: who controls the drone next, the answer to whoever asked, and the changes
 * to announce.
 */
public record LeaseStep(ControlState control, LeaseAnswer answer, List<ControlChange> changes) {
    public LeaseStep {
        changes = List.copyOf(changes);
    }

    static LeaseStep granted(ControlState control, ControlChange... changes) {
        return new LeaseStep(control, new LeaseAnswer.Granted(), List.of(changes));
    }

    static LeaseStep denied(ControlState control, LeaseDenial reason, String why) {
        return new LeaseStep(control, new LeaseAnswer.Denied(reason, why), List.of());
    }
}
