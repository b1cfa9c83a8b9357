package org.dronemap.sim.autopilot;

import java.util.Map;

/**
 * The settings that one simulated vehicle is started with. {@code hardware} is the number of its board; {@code
 * streamHertz} flows before anybody asks (negative: as its autopilot does it); {@code stick} is the throttle stick of
 * its remote control, 1000 to 2000; {@code epochMicros} UTC at clock zero; {@code usb}: its link is the first channel,
 * on which unsigned messages always pass; the table of parameters is filled up to {@code parameters}; those of {@code
 * presets} have other values than their autopilot's own.
 */
public record SimulatedVehicleSettings(
        int systemId,
        int hardware,
        int mavlinkVersion,
        double streamHertz,
        int stick,
        long epochMicros,
        boolean usb,
        int parameters,
        Map<String, Double> presets) {
    public SimulatedVehicleSettings {
        if (systemId < 1 || systemId > 255) {
            throw new IllegalArgumentException("system id " + systemId + " is not within 1 to 255");
        }
        presets = Map.copyOf(presets);
    }

    /** The same with another system id. */
    SimulatedVehicleSettings withSystemId(int other) {
        return new SimulatedVehicleSettings(
                other, hardware, mavlinkVersion, streamHertz, stick, epochMicros, usb, parameters, presets);
    }
}
