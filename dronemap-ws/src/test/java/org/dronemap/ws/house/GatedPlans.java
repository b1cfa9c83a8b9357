package org.dronemap.ws.house;

import org.dronemap.ws.plan.PlanDesk;
import org.dronemap.ws.plan.PlanJob;
import org.dronemap.ws.plan.PlanListener;

/** Searches for plans that begin only when a gate is open. */
public final class GatedPlans implements PlanListener {
    private final Gate gate;

    private GatedPlans(Gate gate) {
        this.gate = gate;
    }

    public static void of(TestHouse house, Gate gate) {
        house.bean(PlanDesk.class).addListener(new GatedPlans(gate));
    }

    @Override
    public void changed(PlanJob job) {
        // Who asks for a plan hears of it too, and must not wait.
        if (Thread.currentThread().getName().contains("planner")) {
            gate.pass();
        }
    }

    @Override
    public void removed(PlanJob job) {
        // nothing is searched for
    }
}
