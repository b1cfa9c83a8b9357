package org.dronemap.sim.flight;

import org.dronemap.sim.physics.Airframe;
import org.dronemap.sim.physics.BatteryModel;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.MulticopterBody;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.sim.physics.SensorNoise;
import org.dronemap.sim.physics.VehicleBody;
import org.dronemap.sim.physics.WindModel;

/**
 * The body, battery and sensors of one simulated vehicle, in a local frame with its starting point as origin. Owned by
 * the fleet's thread.
 */
public final class SimulatedCraft {
    private static final long SETTLED_MILLIS = 1_600;
    private static final double CRASH_SPEED = 3.0;
    private static final MotionSetpoint STILL = new MotionSetpoint.Still();

    private final LocalFrame frame;
    private final VehicleBody body;
    private final BatteryModel battery;
    private final WindModel wind;
    private final NavigationEstimator navigation;
    private final SensorNoise noise;
    private LocalFrame home;
    private boolean armed;
    private boolean motorFailed;
    private boolean crashed;
    private boolean landed = true;
    private long groundedSince;

    public SimulatedCraft(LocalFrame frame, BatteryModel battery, WindModel wind, NavigationEstimator navigation) {
        this(frame, Airframe.quadcopter(), battery, wind, navigation);
    }

    public SimulatedCraft(
            LocalFrame frame, Airframe airframe, BatteryModel battery, WindModel wind, NavigationEstimator navigation) {
        this(frame, new MulticopterBody(airframe, 0), battery, wind, navigation);
    }

    public SimulatedCraft(
            LocalFrame frame, VehicleBody body, BatteryModel battery, WindModel wind, NavigationEstimator navigation) {
        this(frame, body, battery, wind, navigation, SensorNoise.none());
    }

    public SimulatedCraft(
            LocalFrame frame,
            VehicleBody body,
            BatteryModel battery,
            WindModel wind,
            NavigationEstimator navigation,
            SensorNoise noise) {
        this.noise = noise;
        this.frame = frame;
        this.home = frame;
        this.body = body;
        this.battery = battery;
        this.wind = wind;
        this.navigation = navigation;
    }

    public void step(MotionSetpoint setpoint, long nowMillis, double seconds) {
        navigation.step(nowMillis);
        wind.step(seconds);
        noise.step(seconds);
        body.setGround(noise.height());
        boolean thrusting = armed && !motorFailed && !crashed && !battery.isEmpty();
        boolean falling = !body.onGround();
        body.step(thrusting ? setpoint : STILL, wind, seconds);
        battery.step(armed, thrusting ? body.thrust() : 0, seconds);
        if (falling && body.onGround() && body.impactSpeed() > CRASH_SPEED) {
            crashed = true;
        }
        settle(nowMillis);
    }

    private void settle(long nowMillis) {
        if (!body.onGround()) {
            landed = false;
            groundedSince = nowMillis;
        } else if (nowMillis - groundedSince >= SETTLED_MILLIS && !crashed) {
            landed = true;
        }
    }

    /** The motors push: the autopilot counts itself as flying just before it leaves the ground. */
    public void liftOff(long nowMillis) {
        landed = false;
        groundedSince = nowMillis;
    }

    public void setArmed(boolean on) {
        armed = on;
    }

    public boolean armed() {
        return armed;
    }

    /** On the ground long enough for the autopilot to believe it; never after a crash. */
    public boolean landed() {
        return landed;
    }

    public void failMotor() {
        motorFailed = true;
    }

    public boolean motorFailed() {
        return motorFailed;
    }

    /** Hits the ground so that it will not fly again until it is repaired. */
    public void crash() {
        crashed = true;
    }

    public boolean crashed() {
        return crashed;
    }

    /** New motors and an upright stand, as after a reboot on the bench. */
    public void repair() {
        motorFailed = false;
        crashed = false;
        landed = body.onGround();
    }

    /** Home becomes the present place. */
    public void setHomeHere() {
        home = frame.shifted(body.position());
    }

    public void setHome(LocalFrame place) {
        home = place;
    }

    public LocalFrame home() {
        return home;
    }

    public NeuPosition homePosition() {
        return frame.locate(home.latitude(), home.longitude(), home.altitudeAmsl() - frame.altitudeAmsl());
    }

    /** The position with {@code metersAboveHome} as its height. */
    public NeuPosition locate(double latitude, double longitude, double metersAboveHome) {
        return frame.locate(latitude, longitude, metersAboveHome + home.altitudeAmsl() - frame.altitudeAmsl());
    }

    /** Where a mission item says to go, in this vehicle's frame. */
    public NeuPosition targetOf(SimulatedMissionItem item) {
        double up = item.up(home) + home.altitudeAmsl() - frame.altitudeAmsl();
        return item.hasPlace()
                ? frame.locate(item.x() / 1e7, item.y() / 1e7, up)
                : body.position().withUp(up);
    }

    public double aboveHome() {
        return body.up() - (home.altitudeAmsl() - frame.altitudeAmsl());
    }

    public SensorNoise noise() {
        return noise;
    }

    /** Where it is in truth, whatever it believes. */
    public NeuPosition truePosition() {
        return noise.truth(body.position());
    }

    public LocalFrame frame() {
        return frame;
    }

    public VehicleBody body() {
        return body;
    }

    public BatteryModel battery() {
        return battery;
    }

    public WindModel wind() {
        return wind;
    }

    public NavigationEstimator navigation() {
        return navigation;
    }
}
