package org.dronemap.core.cloud;

import java.util.concurrent.CompletableFuture;
import org.dronemap.core.access.Principal;
import org.dronemap.core.command.CommandRecord;

/** A command on its way, with the promise of its outcome, and what stands between it and the wire. */
record Underway(
        OpenCommand open,
        ManagedDrone drone,
        Passage.Open passage,
        Principal principal,
        CompletableFuture<CommandRecord> end) {
    boolean isOutdated() {
        return !passage.fence().isOpen();
    }

    Mandate mandate() {
        return new Mandate(open.record().id(), passage.epoch(), open.record().by(), passage.fence());
    }

    /** Given under the control of now. */
    boolean isUnderControl() {
        return passage.fence() != Fence.NONE && passage.fence().isOpen();
    }
}
