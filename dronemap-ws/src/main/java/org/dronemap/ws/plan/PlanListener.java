package org.dronemap.ws.plan;

/** Is told when a planning job changes or is removed; on any thread, so it must return at once. */
public interface PlanListener {
    void changed(PlanJob job);

    void removed(PlanJob job);
}
