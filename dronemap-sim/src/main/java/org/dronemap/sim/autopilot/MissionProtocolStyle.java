package org.dronemap.sim.autopilot;

/** Behaviour of a kind of simulated autopilot in the mission protocol, such as item limits and timeouts. */
public record MissionProtocolStyle(
        boolean overwritesInPlace,
        boolean firstItemIsHome,
        boolean asksWithRequestInt,
        long askAgainMillis,
        long giveUpMillis,
        int maxItems,
        boolean speaks) {}
