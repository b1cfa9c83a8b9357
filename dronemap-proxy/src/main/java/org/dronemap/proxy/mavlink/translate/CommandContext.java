package org.dronemap.proxy.mavlink.translate;

import java.util.function.Consumer;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.proxy.mavlink.procedure.ExchangeObserver;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.dronemap.proxy.mavlink.procedure.MissionDownload;

/**
 * The context of one command to a MAVLink vehicle: its status and parameters, the target, and the listeners.
 *
 * @param parameters what the vehicle said of its parameters
 * @param news hears what was found out on the way
 * @param missionRead hears a mission that was read back after the cloud's own change
 * @param warning hears a sentence for people
 */
public record CommandContext(
        VehicleStatus status,
        ParameterTable parameters,
        MavlinkTarget target,
        ExchangeObserver observer,
        Consumer<DroneEvent> news,
        Consumer<MissionDownload> missionRead,
        Consumer<String> warning) {}
