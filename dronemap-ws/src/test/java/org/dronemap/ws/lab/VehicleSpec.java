package org.dronemap.ws.lab;

import java.util.Map;
import java.util.stream.Stream;
import org.dronemap.sim.autopilot.AutopilotKind;
import org.dronemap.sim.autopilot.SimulatedVehicleSettings;
import org.dronemap.sim.autopilot.arducopter.SimulatedArduCopter;
import org.dronemap.sim.autopilot.ardurover.SimulatedArduRover;
import org.dronemap.sim.autopilot.px4.SimulatedPx4;
import org.dronemap.sim.physics.GroundBody;

/**
 * What a vehicle of the laboratory is made of.
 *
 * @param windSpeed m/s, towards north, with gusts
 * @param readySeconds until its position estimate stands
 * @param presets parameters that are not as its autopilot has them
 * @param usb its link is its first channel, on which it takes unsigned messages even when it has a key
 * @param noisy it is not quite where it believes to be, as with a receiver and a barometer
 */
public record VehicleSpec(
        AutopilotKind kind,
        int mavlinkVersion,
        double windSpeed,
        double readySeconds,
        int parameters,
        Map<String, Double> presets,
        boolean usb,
        boolean noisy) {
    private static final double BY_ITSELF = -1;
    private static final int MIDDLE = 1_500;

    public static final VehicleSpec COPTER = new VehicleSpec(
            new AutopilotKind("arducopter", "\n\nInit ArduCopter V4.5.5 (simulated)\n\n", SimulatedArduCopter::new),
            2,
            0,
            1,
            0,
            Map.of(),
            true,
            false);
    public static final VehicleSpec PX4 =
            new VehicleSpec(new AutopilotKind("px4", "", SimulatedPx4::new), 2, 0, 1, 0, Map.of(), true, false);

    public static final VehicleSpec ROVER = new VehicleSpec(
            new AutopilotKind(
                    "ardurover",
                    "\n\nInit ArduRover V4.5.6 (simulated)\n\n",
                    () -> new GroundBody(0),
                    SimulatedArduRover::new),
            2,
            0,
            1,
            0,
            Map.of(),
            true,
            false);

    /** One of each that flies. */
    public static Stream<VehicleSpec> autopilots() {
        return Stream.of(COPTER, PX4);
    }

    /** One of each that ArduPilot moves. */
    public static Stream<VehicleSpec> arduPilots() {
        return Stream.of(COPTER, ROVER, WingedSpecs.PLANE, WingedSpecs.QUADPLANE);
    }

    public boolean isPx4() {
        return kind.name().equals("px4");
    }

    public VehicleSpec inWind(double speed) {
        return new VehicleSpec(kind, mavlinkVersion, speed, readySeconds, parameters, presets, usb, noisy);
    }

    /** Its position estimate stands so long after it was switched on. */
    public VehicleSpec readyAfter(double seconds) {
        return new VehicleSpec(kind, mavlinkVersion, windSpeed, seconds, parameters, presets, usb, noisy);
    }

    public VehicleSpec with(Map<String, Double> values) {
        return new VehicleSpec(kind, mavlinkVersion, windSpeed, readySeconds, parameters, values, usb, noisy);
    }

    /** On a link where it insists on signatures once it has a key. */
    public VehicleSpec insisting() {
        return new VehicleSpec(kind, mavlinkVersion, windSpeed, readySeconds, parameters, presets, false, noisy);
    }

    /** With so many parameters as real ones have. */
    public VehicleSpec withParameters(int count) {
        return new VehicleSpec(kind, mavlinkVersion, windSpeed, readySeconds, count, presets, usb, noisy);
    }

    /** Where it truly is differs from where it believes to be by some metres, which wander. */
    public VehicleSpec withNoise() {
        return new VehicleSpec(kind, mavlinkVersion, windSpeed, readySeconds, parameters, presets, usb, true);
    }

    /** It speaks MAVLink 1. */
    public VehicleSpec ofMavlink1() {
        return new VehicleSpec(kind, 1, windSpeed, readySeconds, parameters, presets, usb, noisy);
    }

    @Override
    public String toString() {
        return kind.name();
    }

    SimulatedVehicleSettings settings(int systemId, int hardware, long epochMicros) {
        return new SimulatedVehicleSettings(
                systemId, hardware, mavlinkVersion, BY_ITSELF, MIDDLE, epochMicros, usb, parameters, presets);
    }
}
