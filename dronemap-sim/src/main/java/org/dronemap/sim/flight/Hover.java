package org.dronemap.sim.flight;

import org.dronemap.sim.physics.Position;
import org.dronemap.sim.physics.Setpoint;

/** Brakes and stays; on the ground it remains there. */
public final class Hover implements Manoeuvre {
    private final Cruise cruise;
    private final boolean grounded;
    private final Position place;

    public Hover(Craft craft, Cruise cruise) {
        this.cruise = cruise;
        this.grounded = craft.body().onGround();
        this.place = craft.body().stoppingPoint();
    }

    @Override
    public Setpoint fly(Craft craft, long nowMillis) {
        return grounded ? new Setpoint.Still() : cruise.to(place, Double.NaN);
    }
}
