package org.dronemap.sim.autopilot;

/** The behaviour of an autopilot in the mission protocol. */
public record MissionProtocolStyle(
        boolean overwritesInPlace,
        boolean firstItemIsHome,
        boolean asksWithRequestInt,
        long askAgainMillis,
        long giveUpMillis,
        int maxItems,
        boolean speaks) {}
