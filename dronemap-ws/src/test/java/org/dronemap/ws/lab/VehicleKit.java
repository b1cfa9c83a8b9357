package org.dronemap.ws.lab;

import java.util.Map;
import java.util.stream.Stream;
import org.dronemap.sim.personality.AutopilotKind;
import org.dronemap.sim.personality.VehicleSettings;
import org.dronemap.sim.personality.arducopter.ArduCopter;
import org.dronemap.sim.personality.px4.Px4;

/**
 * What a vehicle of the laboratory is made of.
 *
 * @param windSpeed m/s, towards north, with gusts
 * @param readySeconds until its position estimate stands
 * @param presets parameters that are not as its autopilot has them
 * @param usb its link is its first channel, on which it takes unsigned messages even when it has a key
 */
public record VehicleKit(
        AutopilotKind kind,
        int mavlinkVersion,
        double windSpeed,
        double readySeconds,
        int parameters,
        Map<String, Double> presets,
        boolean usb) {
    private static final double BY_ITSELF = -1;
    private static final int MIDDLE = 1_500;

    public static final VehicleKit COPTER = new VehicleKit(
            new AutopilotKind("arducopter", "\n\nInit ArduCopter V4.5.5 (simulated)\n\n", ArduCopter::new),
            2,
            0,
            1,
            0,
            Map.of(),
            true);
    public static final VehicleKit PX4 =
            new VehicleKit(new AutopilotKind("px4", "", Px4::new), 2, 0, 1, 0, Map.of(), true);

    /** One of each. */
    public static Stream<VehicleKit> autopilots() {
        return Stream.of(COPTER, PX4);
    }

    public boolean isPx4() {
        return kind.name().equals("px4");
    }

    public VehicleKit inWind(double speed) {
        return new VehicleKit(kind, mavlinkVersion, speed, readySeconds, parameters, presets, usb);
    }

    public VehicleKit with(Map<String, Double> values) {
        return new VehicleKit(kind, mavlinkVersion, windSpeed, readySeconds, parameters, values, usb);
    }

    /** On a link where it insists on signatures once it has a key. */
    public VehicleKit insisting() {
        return new VehicleKit(kind, mavlinkVersion, windSpeed, readySeconds, parameters, presets, false);
    }

    /** With so many parameters as real ones have. */
    public VehicleKit withParameters(int count) {
        return new VehicleKit(kind, mavlinkVersion, windSpeed, readySeconds, count, presets, usb);
    }

    /** It speaks MAVLink 1. */
    public VehicleKit ofMavlink1() {
        return new VehicleKit(kind, 1, windSpeed, readySeconds, parameters, presets, usb);
    }

    @Override
    public String toString() {
        return kind.name();
    }

    VehicleSettings settings(int systemId, int hardware, long epochMicros) {
        return new VehicleSettings(
                systemId, hardware, mavlinkVersion, BY_ITSELF, MIDDLE, epochMicros, usb, parameters, presets);
    }
}
