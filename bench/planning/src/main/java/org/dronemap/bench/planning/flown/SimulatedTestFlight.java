package org.dronemap.bench.planning.flown;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.sim.autopilot.AutopilotKind;
import org.dronemap.sim.autopilot.SimulatedVehicle;
import org.dronemap.sim.autopilot.SimulatedVehicleSettings;
import org.dronemap.sim.autopilot.arducopter.SimulatedArduCopter;
import org.dronemap.sim.flight.NavigationEstimator;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.physics.BatteryModel;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.WindModel;

/** One simulated copter with a clock of its own that runs as fast as it can be computed. Used by one thread. */
final class SimulatedTestFlight {
    private static final int STEP_MILLIS = 50;
    private static final long LONGEST_MILLIS = 7_200_000;
    private static final double CAPACITY_MILLIAMP_HOURS = 20_000;
    private static final AutopilotKind COPTER = new AutopilotKind("arducopter", "", SimulatedArduCopter::new);
    private static final int SET_MODE = 176;
    private static final int ARM = 400;
    private static final int START_MISSION = 300;
    private static final int GUIDED = 4;

    private final SimulatedVehicle vehicle;
    private final FrameReader toVehicle = new FrameReader();
    private final FrameWriter ground = new FrameWriter(255, 190, 2);
    private long now;
    private double joules;

    /** Time and energy of a flight from lift-off to touch-down. */
    record FlightEffort(double seconds, double joules) {
        FlightEffort minus(FlightEffort other) {
            return new FlightEffort(seconds - other.seconds, joules - other.joules);
        }
    }

    SimulatedTestFlight(LocalFrame home, WindModel wind) {
        SimulatedVehicleSettings settings = new SimulatedVehicleSettings(1, 1, 2, 0, 1_500, 0, false, 0, Map.of("DISARM_DELAY", 120.0));
        SimulatedCraft craft = new SimulatedCraft(home, new BatteryModel(CAPACITY_MILLIAMP_HOURS), wind, new NavigationEstimator(0));
        vehicle = new SimulatedVehicle(settings, COPTER, craft, bytes -> {});
    }

    FlightEffort fly(List<MissionItem> mission) {
        run(5_000);
        List<org.dronemap.sim.flight.SimulatedMissionItem> items = new ArrayList<>();
        items.add(org.dronemap.sim.flight.SimulatedMissionItem.home(vehicle.craft().home()));
        mission.forEach(item -> items.add(wire(item)));
        vehicle.autopilot().plan().replaceAll(items);
        vehicle.autopilot().missionChanged();
        order(SET_MODE, 1, GUIDED);
        order(ARM, 1, 0);
        long began = now;
        joules = 0;
        order(START_MISSION, 0, 0);
        int flying = 0;
        while (vehicle.craft().armed()) {
            run(STEP_MILLIS);
            flying += vehicle.craft().body().onGround() ? 0 : STEP_MILLIS;
            if (now - began > LONGEST_MILLIS) {
                throw new IllegalStateException("a flight does not end");
            }
        }
        return new FlightEffort(flying / 1_000.0, joules);
    }

    private void run(long millis) {
        for (long until = now + millis; now < until; ) {
            now += STEP_MILLIS;
            vehicle.advance(now);
            BatteryModel battery = vehicle.craft().battery();
            joules += battery.volts() * battery.amps() * STEP_MILLIS / 1_000.0;
        }
    }

    private void order(int command, float first, float second) {
        CommandLong order = new CommandLong(1, 1, command, 0, first, second, 0, 0, 0, 0, 0);
        toVehicle.read(ByteBuffer.wrap(ground.frame(order)), vehicle::receive);
    }

    private static org.dronemap.sim.flight.SimulatedMissionItem wire(MissionItem item) {
        if (item instanceof MissionItem.TakeOff takeOff) {
            return plain(org.dronemap.sim.flight.SimulatedMissionItem.TAKEOFF, 0, takeOff.altitudeMeters());
        }
        if (item instanceof MissionItem.Wait wait) {
            return plain(org.dronemap.sim.flight.SimulatedMissionItem.DELAY, wait.seconds(), 0);
        }
        if (item instanceof MissionItem.Land) {
            return plain(org.dronemap.sim.flight.SimulatedMissionItem.LAND, 0, 0);
        }
        if (item instanceof MissionItem.Waypoint waypoint
                && waypoint.altitude().reference() == Altitude.Reference.AMSL) {
            return new org.dronemap.sim.flight.SimulatedMissionItem(
                    org.dronemap.sim.flight.SimulatedMissionItem.WAYPOINT,
                    org.dronemap.sim.flight.SimulatedMissionItem.FRAME_AMSL,
                    1,
                    (float) waypoint.holdSeconds(),
                    0,
                    0,
                    0,
                    (int) Math.round(waypoint.point().latitudeDegrees() * 1e7),
                    (int) Math.round(waypoint.point().longitudeDegrees() * 1e7),
                    (float) waypoint.altitude().meters());
        }
        throw new IllegalArgumentException("no plan of these has " + item);
    }

    private static org.dronemap.sim.flight.SimulatedMissionItem plain(int command, double first, double height) {
        return new org.dronemap.sim.flight.SimulatedMissionItem(command, 3, 1, (float) first, 0, 0, 0, 0, 0, (float) height);
    }
}
