package org.dronemap.sim.physics;

import org.jspecify.annotations.Nullable;

/**
 * The flight physics of one simulated multicopter: position, velocity and attitude, moved in small steps. Owned by its
 * vehicle.
 */
public final class MulticopterBody extends FlyingBody {
    private static final double CLEAR_METERS = 0.05;
    private static final double POSITION_GAIN = 1.0;
    private static final double ATTITUDE_SECONDS = 0.15;
    private static final double TUMBLE_ROLL = Math.toRadians(65);

    private final Airframe airframe;
    private double ground;
    private @Nullable MovingTargetController chaser;

    public MulticopterBody(Airframe airframe, double yaw) {
        super(yaw);
        this.airframe = airframe;
    }

    @Override
    public void step(MotionSetpoint setpoint, WindModel wind, double seconds) {
        if (!(setpoint instanceof MotionSetpoint.Track)) {
            chaser = null;
        }
        if (setpoint instanceof MotionSetpoint.Reach reach) {
            reach(reach, 0, 0, 0, wind, seconds);
        } else if (setpoint instanceof MotionSetpoint.Track chase) {
            chase(chase, wind, seconds);
        } else if (setpoint instanceof MotionSetpoint.Velocity velocity) {
            powered(velocity.north(), velocity.east(), velocity.up(), wind, seconds);
            turn(velocity.yaw(), seconds);
        } else {
            unpowered(seconds);
        }
        meetGround();
    }

    /** Comes up to a place that moves with that velocity. */
    private void reach(
            MotionSetpoint.Reach reach,
            double movingNorth,
            double movingEast,
            double movingUp,
            WindModel wind,
            double seconds) {
        double distance =
                Math.hypot(reach.target().north() - north, reach.target().east() - east);
        double speed = Math.min(reach.horizontalSpeed(), approach(distance, airframe.horizontalDeceleration()));
        double share = distance > 1e-9 ? speed / distance : 0;
        powered(
                movingNorth + (reach.target().north() - north) * share,
                movingEast + (reach.target().east() - east) * share,
                movingUp + climb(reach),
                wind,
                seconds);
        turn(reach.yaw(), seconds);
    }

    private double climb(MotionSetpoint.Reach reach) {
        double rise = reach.target().up() - up;
        double vertical = approach(Math.abs(rise), airframe.verticalAcceleration());
        return rise > 0 ? Math.min(vertical, reach.climbSpeed()) : -Math.min(vertical, reach.sinkSpeed());
    }

    private void chase(MotionSetpoint.Track chase, WindModel wind, double seconds) {
        MotionSetpoint.Reach reach = chase.place();
        if (airframe.isNeverAtItsEnd()) {
            reach(reach, chase.north(), chase.east(), chase.up(), wind, seconds);
            return;
        }
        HorizontalVector leans = leans(chase, wind, seconds);
        setAttitude(
                Math.atan2(leans.east() * Math.cos(yaw) - leans.north() * Math.sin(yaw), GRAVITY),
                -Math.atan2(leans.north() * Math.cos(yaw) + leans.east() * Math.sin(yaw), GRAVITY),
                seconds);
        double forward = -GRAVITY * Math.tan(pitch);
        double right = GRAVITY * Math.tan(roll);
        HorizontalVector resistance = resistance(wind);
        velocityNorth += (forward * Math.cos(yaw) - right * Math.sin(yaw) - resistance.north()) * seconds;
        velocityEast += (forward * Math.sin(yaw) + right * Math.cos(yaw) - resistance.east()) * seconds;
        rise(chase.up() + climb(reach), seconds);
        turn(reach.yaw(), seconds);
    }

    /** What the autopilot leans for: what the air takes of that it learns only as it falls behind. */
    private HorizontalVector leans(MotionSetpoint.Track chase, WindModel wind, double seconds) {
        MovingTargetController.Moving here = new MovingTargetController.Moving(
                new HorizontalVector(north, east), new HorizontalVector(velocityNorth, velocityEast));
        if (chaser == null) {
            chaser = new MovingTargetController(here, GRAVITY * Math.tan(airframe.asksToLean()), resistance(wind));
        }
        NeuPosition place = chase.place().target();
        MovingTargetController.Moving target = new MovingTargetController.Moving(
                new HorizontalVector(place.north(), place.east()), new HorizontalVector(chase.north(), chase.east()));
        return chaser.leans(target, here, chase.place().horizontalSpeed(), seconds);
    }

    private HorizontalVector resistance(WindModel wind) {
        HorizontalVector air = new HorizontalVector(velocityNorth - wind.north(), velocityEast - wind.east());
        return air.times(airframe.resistance(air.length()));
    }

    /** Speed from which a constant deceleration still stops in time; soft close to the target. */
    private static double approach(double distance, double acceleration) {
        double linear = acceleration / (POSITION_GAIN * POSITION_GAIN);
        return distance <= linear ? distance * POSITION_GAIN : Math.sqrt(2 * acceleration * (distance - linear / 2));
    }

    private void powered(double wantNorth, double wantEast, double wantUp, WindModel wind, double seconds) {
        double limit = airframe.horizontalAcceleration();
        double accelerationNorth = (wantNorth - velocityNorth) / seconds;
        double accelerationEast = (wantEast - velocityEast) / seconds;
        double size = Math.hypot(accelerationNorth, accelerationEast);
        if (size > limit) {
            accelerationNorth *= limit / size;
            accelerationEast *= limit / size;
        }
        boolean airborne = up > ground + CLEAR_METERS;
        lean(accelerationNorth, accelerationEast, wind, airborne ? seconds : 0);
        if (airborne) {
            // The mean wind is flown against by leaning; what a gust adds comes too quickly for that.
            velocityNorth += (accelerationNorth + wind.gustNorth() * airframe.drag() / 2) * seconds;
            velocityEast += (accelerationEast + wind.gustEast() * airframe.drag() / 2) * seconds;
        }
        rise(wantUp, seconds);
    }

    private void rise(double wantUp, double seconds) {
        double accelerationUp = clamp((wantUp - velocityUp) / seconds, airframe.verticalAcceleration() * 2);
        velocityUp += accelerationUp * seconds;
        thrust = (1 + accelerationUp / GRAVITY + Math.max(0, velocityUp) * 0.05)
                / Math.max(0.5, Math.cos(roll) * Math.cos(pitch));
        move(seconds);
    }

    private void lean(double accelerationNorth, double accelerationEast, WindModel wind, double seconds) {
        if (seconds == 0) {
            setAttitude(0, 0, 0.05);
            return;
        }
        double forceNorth = accelerationNorth + airframe.drag() * (velocityNorth - wind.north());
        double forceEast = accelerationEast + airframe.drag() * (velocityEast - wind.east());
        double forward = forceNorth * Math.cos(yaw) + forceEast * Math.sin(yaw);
        double right = forceEast * Math.cos(yaw) - forceNorth * Math.sin(yaw);
        setAttitude(
                clamp(Math.atan2(right, GRAVITY), airframe.maxLean()),
                clamp(-Math.atan2(forward, GRAVITY), airframe.maxLean()),
                seconds);
    }

    private void setAttitude(double wantedRoll, double wantedPitch, double seconds) {
        double share = 1 - Math.exp(-seconds / ATTITUDE_SECONDS);
        rollRate = (wantedRoll - roll) * share / seconds;
        pitchRate = (wantedPitch - pitch) * share / seconds;
        roll += rollRate * seconds;
        pitch += pitchRate * seconds;
    }

    private void turn(double wantedYaw, double seconds) {
        if (Double.isNaN(wantedYaw)) {
            yawRate = 0;
            return;
        }
        double error = Math.IEEEremainder(wantedYaw - yaw, 2 * Math.PI);
        double change = clamp(error, airframe.yawRate() * seconds);
        yawRate = change / seconds;
        yaw = Math.IEEEremainder(yaw + change, 2 * Math.PI);
    }

    private void unpowered(double seconds) {
        thrust = 0;
        yawRate = 0;
        if (up <= ground && velocityUp <= 0) {
            velocityNorth = 0;
            velocityEast = 0;
            rollRate = 0;
            pitchRate = 0;
            return;
        }
        double drag =
                GRAVITY * velocityUp * Math.abs(velocityUp) / (airframe.terminalSpeed() * airframe.terminalSpeed());
        velocityUp -= (GRAVITY + drag) * seconds;
        double keep = Math.exp(-airframe.drag() * seconds);
        velocityNorth *= keep;
        velocityEast *= keep;
        setAttitude(TUMBLE_ROLL, pitch, seconds);
        move(seconds);
    }

    private void move(double seconds) {
        north += velocityNorth * seconds;
        east += velocityEast * seconds;
        up += velocityUp * seconds;
    }

    @Override
    public void setGround(double meters) {
        boolean standing = onGround();
        ground = meters;
        if (standing) {
            up = ground;
        }
    }

    private void meetGround() {
        if (up > ground) {
            return;
        }
        if (velocityUp < 0) {
            impactSpeed = -velocityUp;
        }
        up = ground;
        velocityUp = Math.max(0, velocityUp);
        velocityNorth = 0;
        velocityEast = 0;
    }

    @Override
    public NeuPosition stoppingPoint() {
        double speed = groundSpeed();
        double distance = speed * speed / (2 * airframe.horizontalAcceleration());
        double share = speed > 1e-6 ? distance / speed : 0;
        double rise = velocityUp * Math.abs(velocityUp) / (2 * airframe.verticalAcceleration());
        return new NeuPosition(north + velocityNorth * share, east + velocityEast * share, Math.max(ground, up + rise));
    }

    @Override
    public boolean onGround() {
        return up <= ground && velocityUp <= 0;
    }

    @Override
    public double airSpeed(WindModel wind) {
        return up > ground + CLEAR_METERS ? Math.hypot(velocityNorth - wind.north(), velocityEast - wind.east()) : 0;
    }
}
