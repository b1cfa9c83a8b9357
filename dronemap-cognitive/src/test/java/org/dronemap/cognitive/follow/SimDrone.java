package org.dronemap.cognitive.follow;

import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.Map;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.separation.DroneFix;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.sim.autopilot.AutopilotKind;
import org.dronemap.sim.autopilot.SimulatedVehicle;
import org.dronemap.sim.autopilot.SimulatedVehicleSettings;
import org.dronemap.sim.autopilot.arducopter.SimulatedArduCopter;
import org.dronemap.sim.flight.NavigationEstimator;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.physics.Airframe;
import org.dronemap.sim.physics.BatteryModel;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.sim.physics.VehicleBody;
import org.dronemap.sim.physics.WindModel;

/** A simulated ArduCopter in the air, told by real frames where to be, on a clock that the trial turns. */
final class SimDrone implements TestCopter {
    static final Geodetic HOME = new Geodetic(47.3977, 8.5456);
    static final double HOME_AMSL = 488;

    private static final int ARM = 400;
    private static final int TAKE_OFF = 22;
    private static final int SET_MODE = 176;
    private static final int GUIDED = 4;

    private final LocalFrame frame;
    private final SimulatedCraft craft;
    private final SimulatedVehicle vehicle;
    private final FrameReader toVehicle = new FrameReader();
    private final FrameWriter ground = new FrameWriter(255, 190, 2);
    private long millis;
    private final long zero;

    /** In the air over its home at that height, in a wind of so many m/s. */
    SimDrone(double meters, double wind, long seed) {
        this(HOME, meters, wind, seed);
    }

    /** The same over another home. */
    SimDrone(Geodetic home, double meters, double wind, long seed) {
        this(home, Airframe.quadcopter(), meters, wind, seed);
    }

    /** The same that leans no farther than a real ArduCopter as it is delivered. */
    static SimDrone leaning(double meters, double wind, long seed) {
        return new SimDrone(HOME, Airframe.leaning(30), meters, wind, seed);
    }

    private SimDrone(Geodetic home, Airframe airframe, double meters, double wind, long seed) {
        frame = new LocalFrame(home.latitudeDegrees(), home.longitudeDegrees(), HOME_AMSL);
        craft = new SimulatedCraft(
                frame,
                airframe,
                new BatteryModel(50_000),
                new WindModel(wind, seed % 7, seed),
                new NavigationEstimator(3_000));
        vehicle = new SimulatedVehicle(
                new SimulatedVehicleSettings(1, 1, 2, -1, 1500, 0, true, 0, Map.of("WPNAV_SPEED", 1_500.0)),
                new AutopilotKind("arducopter", "", SimulatedArduCopter::new),
                craft,
                bytes -> {});
        live(6);
        send(new CommandLong(1, 1, SET_MODE, 0, 1, GUIDED, 0, 0, 0, 0, 0));
        send(new CommandLong(1, 1, ARM, 0, 1, 0, 0, 0, 0, 0, 0));
        send(new CommandLong(1, 1, TAKE_OFF, 0, 0, 0, 0, 0, 0, 0, (float) meters));
        live(25);
        zero = millis;
    }

    @Override
    public void live(double seconds) {
        long until = millis + Math.round(seconds * 1_000);
        while (millis < until) {
            if (millis % 1_000 < 20) {
                send(new Heartbeat(6, 8, 0, 0, 4, 3));
            }
            millis += Math.min(20, until - millis);
            vehicle.advance(millis);
        }
    }

    private void send(Message message) {
        toVehicle.read(ByteBuffer.wrap(ground.frame(message)), vehicle::receive);
    }

    @Override
    public void hear(GuidanceSetpoint aim) {
        send(SetpointMessages.moving(aim));
    }

    @Override
    public void hearPlace(GuidanceSetpoint aim) {
        send(SetpointMessages.place(aim));
    }

    @Override
    public NeuPosition position() {
        return craft.body().position();
    }

    double yawDegrees() {
        return Math.toDegrees(craft.body().yaw());
    }

    @Override
    public DroneFix whereabouts(Instant at) {
        VehicleBody body = craft.body();
        NeuPosition here = body.position();
        return new DroneFix(
                at,
                new Geodetic(frame.latitudeOf(here), frame.longitudeOf(here)),
                frame.altitudeOf(here),
                body.velocityEast(),
                body.velocityNorth());
    }

    @Override
    public Geodetic place(double east, double north) {
        NeuPosition there = new NeuPosition(north, east, 0);
        return new Geodetic(frame.latitudeOf(there), frame.longitudeOf(there));
    }

    /** Since it was in the air. */
    double seconds() {
        return (millis - zero) / 1_000.0;
    }
}
