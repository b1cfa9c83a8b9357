package org.dronemap.sim;

import java.util.Locale;
import java.util.function.Consumer;
import org.dronemap.sim.autopilot.AutopilotKind;
import org.dronemap.sim.autopilot.SimulatedVehicle;
import org.dronemap.sim.autopilot.SimulatedVehicleSettings;
import org.dronemap.sim.autopilot.arducopter.SimulatedArduCopter;
import org.dronemap.sim.autopilot.arduplane.SimulatedArduPlane;
import org.dronemap.sim.autopilot.ardurover.SimulatedArduRover;
import org.dronemap.sim.autopilot.px4.SimulatedPx4;
import org.dronemap.sim.flight.NavigationEstimator;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.link.SimulatedFleet;
import org.dronemap.sim.physics.BatteryModel;
import org.dronemap.sim.physics.FixedWingBody;
import org.dronemap.sim.physics.GroundBody;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.sim.physics.QuadPlaneBody;
import org.dronemap.sim.physics.SensorNoise;
import org.dronemap.sim.physics.WindModel;

/** Builds the simulated fleet: vehicles on a square grid, ten metres apart, north-east of home. */
final class SimulatedFleetBuilder {
    private static final double SPACING_METERS = 60;
    private static final double BATTERY_MILLIAMP_HOURS = 5200;
    private static final int SYSTEM_IDS = 254;
    private static final long SEEDS_APART = 1_000_003;
    private static final double BREEZE = 4;
    private static final long FOR_GOOD_MILLIS = Long.MAX_VALUE / 2;

    static final AutopilotKind ARDUCOPTER =
            new AutopilotKind("arducopter", "\n\nInit ArduCopter V4.5.5 (simulated)\n\n", SimulatedArduCopter::new);
    static final AutopilotKind ARDUROVER = new AutopilotKind(
            "ardurover", "\n\nInit ArduRover V4.5.6 (simulated)\n\n", () -> new GroundBody(0), SimulatedArduRover::new);
    static final AutopilotKind PX4 = new AutopilotKind("px4", "", SimulatedPx4::new);

    /** Where its nose points as it stands; the aeroplane that was recorded stood so. */
    private static final double RUNWAY = Math.toRadians(353);

    static final AutopilotKind ARDUPLANE = new AutopilotKind(
            "arduplane",
            "\n\nInit ArduPlane V4.5.6 (simulated)\n\n",
            () -> new FixedWingBody(RUNWAY),
            SimulatedArduPlane::new);
    static final AutopilotKind QUADPLANE = new AutopilotKind(
            "quadplane",
            "\n\nInit ArduPlane V4.5.6 (simulated)\n\n",
            () -> new QuadPlaneBody(RUNWAY),
            SimulatedArduPlane::quadPlane);

    private final SimulatorOptions options;
    private final long epochMicros;

    SimulatedFleetBuilder(SimulatorOptions options, long epochMicros) {
        this.options = options;
        this.epochMicros = epochMicros;
    }

    SimulatedFleet build() {
        SimulatedFleet fleet = new SimulatedFleet(options.server(), options.speedup());
        for (int i = 0; i < options.count(); i++) {
            int index = i;
            fleet.add(link -> vehicle(index, link));
        }
        return fleet;
    }

    SimulatedVehicle vehicle(int index, Consumer<byte[]> link) {
        int side = (int) Math.ceil(Math.sqrt(options.count()));
        int row = index / side;
        int column = index % side;
        long seed = options.seed() * SEEDS_APART + index;
        SensorNoise noise = options.oddities().noisy()
                ? SensorNoise.of(options.oddities().noiseSeed() * SEEDS_APART + index)
                : SensorNoise.none();
        LocalFrame place = options.home()
                .shifted(new NeuPosition(row * SPACING_METERS, column * SPACING_METERS, noise.homeOffset()));
        double towards = (options.seed() & 7) * Math.PI / 4;
        AutopilotKind kind = kind(index);
        SimulatedCraft craft = new SimulatedCraft(
                place,
                kind.body().get(),
                new BatteryModel(BATTERY_MILLIAMP_HOURS),
                new WindModel(windSpeed(), towards, seed),
                new NavigationEstimator((long) (options.readyAfterSeconds() * 1000)),
                noise);
        int systemId = (options.firstSystemId() - 1 + index) % SYSTEM_IDS + 1;
        SimulatedVehicleSettings settings = new SimulatedVehicleSettings(
                systemId,
                options.firstHardware() == 0 ? systemId : options.firstHardware() + index,
                options.mavlink1() ? 1 : 2,
                options.rateHertz(),
                options.stickLow() ? 1000 : 1500,
                epochMicros,
                options.usb(),
                options.parameters(),
                options.presets());
        SimulatedVehicle vehicle = new SimulatedVehicle(settings, kind, craft, link);
        vehicle.companions().set(options.oddities().companions());
        vehicle.setCells(options.oddities().cells());
        if (options.asleep()) {
            vehicle.silence(FOR_GOOD_MILLIS);
        }
        return vehicle;
    }

    /** Noise has a breeze with it. */
    private double windSpeed() {
        return options.oddities().noisy() && options.windSpeed() == 0 ? BREEZE : options.windSpeed();
    }

    private AutopilotKind kind(int index) {
        return switch (options.personality().toLowerCase(Locale.ROOT)) {
            case "px4" -> PX4;
            case "ardurover" -> ARDUROVER;
            case "arduplane" -> ARDUPLANE;
            case "quadplane" -> QUADPLANE;
            case "mixed" -> index % 2 == 0 ? ARDUCOPTER : PX4;
            default -> ARDUCOPTER;
        };
    }
}
