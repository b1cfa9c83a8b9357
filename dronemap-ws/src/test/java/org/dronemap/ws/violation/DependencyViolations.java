package org.dronemap.ws.violation;

import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.command.Command;
import org.dronemap.store.memory.MemoryMissionStore;
import org.dronemap.ws.account.PasswordHashing;
import org.java_websocket.drafts.Draft;
import org.java_websocket.drafts.Draft_6455;

/** Commands a vehicle past the gate, reaches into a store, guesses passwords, and speaks WebSocket without a bound. */
public final class DependencyViolations {
    private final MemoryMissionStore store = new MemoryMissionStore();
    private final Draft unbounded = new Draft_6455();

    public boolean guess(PasswordHashing passwords) {
        return passwords.matches("a guess", "a hash");
    }

    public void violate(VehicleChannel channel, VehicleChannel.Report report) {
        if (store.missions().isEmpty() && unbounded.getRole() == null) {
            channel.perform(SendAuthority.HOUSEKEEPING, new Command.Arm(), report);
        }
    }
}
