package org.dronemap.sim.physics;

/** The physics of one simulated vehicle: position, velocity and attitude, moved in small steps. Owned by its vehicle. */
public interface VehicleBody {
    void step(MotionSetpoint setpoint, WindModel wind, double seconds);

    NeuPosition position();

    /** Where it comes to rest if it brakes now. */
    NeuPosition stoppingPoint();

    boolean onGround();

    /** The ground is at this height from now on, metres: what measures heights has drifted. */
    default void setGround(double meters) {}

    double up();

    double velocityNorth();

    double velocityEast();

    double velocityUp();

    double groundSpeed();

    double airSpeed(WindModel wind);

    double roll();

    double pitch();

    double yaw();

    double rollRate();

    double pitchRate();

    double yawRate();

    /** Share of what it needs to stay as it is: hovering, or driving at cruise speed. */
    double thrust();

    /** Vertical speed of the last touch of the ground, m/s. */
    double impactSpeed();
}
