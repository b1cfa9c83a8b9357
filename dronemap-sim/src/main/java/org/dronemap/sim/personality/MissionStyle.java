package org.dronemap.sim.personality;

/** How an autopilot takes a mission over the wire. */
public record MissionStyle(
        boolean overwritesInPlace,
        boolean firstItemIsHome,
        boolean asksWithRequestInt,
        long askAgainMillis,
        long giveUpMillis,
        int maxItems,
        boolean speaks) {}
