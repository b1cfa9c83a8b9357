package org.dronemap.core.lease;

import java.util.List;

/** Result of an event in the lease machine: new control, answer and changes. */
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
