package org.dronemap.ws.testserver;

import org.dronemap.ws.plan.PlanJob;
import org.dronemap.ws.plan.PlanJobExecutor;

/** Searches for plans that begin only when a gate is open. */
public final class LatchedPlanListener implements PlanJobExecutor.PlanListener {
    private final ResponseLatch gate;

    private LatchedPlanListener(ResponseLatch gate) {
        this.gate = gate;
    }

    public static void of(TestServer house, ResponseLatch gate) {
        house.bean(PlanJobExecutor.class).addListener(new LatchedPlanListener(gate));
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
