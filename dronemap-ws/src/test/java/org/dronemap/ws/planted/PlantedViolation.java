package org.dronemap.ws.planted;

import org.dronemap.core.cloud.Mandate;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.command.Command;
import org.dronemap.store.memory.MemoryMissionStore;

/** Commands a vehicle past the gate, and reaches into a store. */
public final class PlantedViolation {
    private final MemoryMissionStore store = new MemoryMissionStore();

    public void violate(VehicleChannel channel, VehicleChannel.Report report) {
        if (store.missions().isEmpty()) {
            channel.perform(Mandate.HOUSEKEEPING, new Command.Arm(), report);
        }
    }
}
