package org.dronemap.sim.flight;

import org.dronemap.sim.physics.Position;
import org.dronemap.sim.physics.Setpoint;

/** Comes down where it is; done when the vehicle knows that it stands. */
public final class Landing implements Manoeuvre {
    private final Cruise cruise;
    private final Position place;
    private boolean done;

    public Landing(Craft craft, Cruise cruise) {
        this.cruise = cruise;
        this.place = craft.body().stoppingPoint();
    }

    @Override
    public Setpoint fly(Craft craft, long nowMillis) {
        done = craft.landed();
        return craft.body().onGround()
                ? new Setpoint.Still()
                : cruise.downAt(place, craft.body().up());
    }

    @Override
    public boolean done() {
        return done;
    }
}
