package org.dronemap.sim.physics;

/**
 * The flight physics of one simulated aeroplane with lift motors: they bear it until its wings can, and again once it
 * is told to go somewhere as a multicopter does. Owned by its vehicle.
 */
public final class QuadPlaneBody implements VehicleBody {
    /** From this speed on its wings bear it. */
    private static final double BORNE_SPEED = 18;

    private static final double LEAST_TURNING_SPEED = 8;

    private final MulticopterBody lift;
    private final FixedWingBody wings;
    private boolean onWings;
    private double course;

    public QuadPlaneBody(double yaw) {
        this.lift = new MulticopterBody(Airframe.lifted(), yaw);
        this.wings = new FixedWingBody(yaw);
    }

    private VehicleBody active() {
        return onWings ? wings : lift;
    }

    @Override
    public void step(MotionSetpoint setpoint, WindModel wind, double seconds) {
        if (setpoint instanceof MotionSetpoint.Wing wing) {
            fly(wing, wind, seconds);
        } else if (setpoint instanceof MotionSetpoint.Glide || setpoint instanceof MotionSetpoint.Still) {
            active().step(onWings ? new MotionSetpoint.Glide() : new MotionSetpoint.Still(), wind, seconds);
        } else {
            if (onWings) {
                onWings = false;
                lift.continueFrom(wings);
            }
            lift.step(setpoint, wind, seconds);
        }
    }

    private void fly(MotionSetpoint.Wing wing, WindModel wind, double seconds) {
        if (!onWings && (lift.onGround() || lift.groundSpeed() >= BORNE_SPEED)) {
            onWings = true;
            wings.continueFrom(lift);
        }
        if (onWings) {
            wings.step(wing, wind, seconds);
        } else {
            gatherSpeed(wing, wind, seconds);
        }
    }

    /** Lift motors bear it while the propeller at its nose makes it quicker. */
    private void gatherSpeed(MotionSetpoint.Wing wing, WindModel wind, double seconds) {
        course = lift.groundSpeed() > 1 ? Math.atan2(lift.velocityEast(), lift.velocityNorth()) : lift.yaw();
        course += wing.lateral() / Math.max(LEAST_TURNING_SPEED, lift.groundSpeed()) * seconds;
        double speed = Math.max(wing.airspeed(), BORNE_SPEED + 1);
        lift.step(
                new MotionSetpoint.Velocity(speed * Math.cos(course), speed * Math.sin(course), wing.climb(), course),
                wind,
                seconds);
    }

    @Override
    public NeuPosition position() {
        return active().position();
    }

    @Override
    public NeuPosition stoppingPoint() {
        if (!onWings) {
            return lift.stoppingPoint();
        }
        lift.continueFrom(wings);
        return lift.stoppingPoint();
    }

    @Override
    public boolean onGround() {
        return active().onGround();
    }

    @Override
    public double up() {
        return active().up();
    }

    @Override
    public double velocityNorth() {
        return active().velocityNorth();
    }

    @Override
    public double velocityEast() {
        return active().velocityEast();
    }

    @Override
    public double velocityUp() {
        return active().velocityUp();
    }

    @Override
    public double groundSpeed() {
        return active().groundSpeed();
    }

    @Override
    public double airSpeed(WindModel wind) {
        return active().airSpeed(wind);
    }

    @Override
    public double roll() {
        return active().roll();
    }

    @Override
    public double pitch() {
        return active().pitch();
    }

    @Override
    public double yaw() {
        return active().yaw();
    }

    @Override
    public double rollRate() {
        return active().rollRate();
    }

    @Override
    public double pitchRate() {
        return active().pitchRate();
    }

    @Override
    public double yawRate() {
        return active().yawRate();
    }

    @Override
    public double thrust() {
        return active().thrust();
    }

    @Override
    public double impactSpeed() {
        return active().impactSpeed();
    }
}
