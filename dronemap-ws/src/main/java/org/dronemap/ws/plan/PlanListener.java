package org.dronemap.ws.plan;

/** Hears of plans on their way, on any thread; must return at once. */
public interface PlanListener {
    void changed(PlanJob job);

    void removed(PlanJob job);
}
