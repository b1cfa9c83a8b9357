package org.dronemap.sim;

import java.util.List;
import org.dronemap.sim.autopilot.LinkCompanion;

/**
 * Peculiarities of the simulated vehicles that a plain one has not: noise of sensors under a seed (0: none), others on
 * their link, and cells that are told one by one (0: their sum alone).
 */
record SimulatorOddities(long noiseSeed, List<LinkCompanion> companions, int cells) {
    static final SimulatorOddities NONE = new SimulatorOddities(0, List.of(), 0);

    private static final int MAX_CELLS = 14;

    static SimulatorOddities parse(CommandLineReader reader) {
        return new SimulatorOddities(
                reader.integer("--noise", 0, 0, Long.MAX_VALUE),
                LinkCompanion.named(reader.text("--companions", "")),
                (int) reader.integer("--cells", 0, 0, MAX_CELLS));
    }

    boolean noisy() {
        return noiseSeed != 0;
    }
}
