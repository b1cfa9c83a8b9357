package org.dronemap.core.cloud;

import java.util.concurrent.CompletableFuture;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.rule.CommandTracker;
import org.dronemap.core.command.CommandRecord;

/** A command under way: its tracker, drone and clearance, and the future of its outcome. */
record PendingCommand(
        CommandTracker open,
        ManagedDrone drone,
        ControlClearance.Cleared passage,
        Principal principal,
        CompletableFuture<CommandRecord> end) {
    boolean isOutdated() {
        return !passage.fence().isOpen();
    }

    SendAuthority mandate() {
        return new SendAuthority(
                open.record().id(), passage.epoch(), open.record().by(), passage.fence());
    }

    /** Given under the control of now. */
    boolean isUnderControl() {
        return passage.fence() != EpochGuard.NONE && passage.fence().isOpen();
    }
}
