package org.dronemap.sim.control;

import java.util.List;
import java.util.Locale;
import org.dronemap.sim.autopilot.LinkCompanion;
import org.dronemap.sim.autopilot.SimulatedVehicle;
import org.dronemap.sim.flight.TextSeverity;

/** Executes the control port's orders about others on the links of the vehicles, and about texts. */
final class CompanionCommands {
    private static final int WORDS_OF_TEXT = 4;

    private CompanionCommands() {}

    static String companions(String[] words, List<SimulatedVehicle> chosen) {
        if (words.length != 3 || chosen.isEmpty()) {
            return "err say companions <sysid|all> <names|none>, of vehicles that there are";
        }
        try {
            List<LinkCompanion> named = LinkCompanion.named(words[2].equals("none") ? "" : words[2]);
            chosen.forEach(vehicle -> vehicle.companions().set(named));
            return "ok " + chosen.size() + " vehicles";
        } catch (IllegalArgumentException e) {
            return "err " + e.getMessage();
        }
    }

    /** {@code line} as it was written, with the case of its words. */
    static String text(String line, List<SimulatedVehicle> chosen) {
        String[] words = line.split("\\s+", WORDS_OF_TEXT);
        if (words.length < WORDS_OF_TEXT || chosen.isEmpty()) {
            return "err say text <sysid|all> <vehicle|companion> <words>, of vehicles that there are";
        }
        String who = words[2].toLowerCase(Locale.ROOT);
        try {
            LinkCompanion companion =
                    who.equals("vehicle") ? null : LinkCompanion.named(who).get(0);
            for (SimulatedVehicle vehicle : chosen) {
                if (companion == null) {
                    vehicle.sendText(TextSeverity.NOTICE, words[3]);
                } else if (vehicle.companions().present().contains(companion)) {
                    vehicle.companions().sendText(companion, TextSeverity.NOTICE, words[3]);
                } else {
                    return "err vehicle " + vehicle.systemId() + " has no " + who + " on its link";
                }
            }
            return "ok " + chosen.size() + " vehicles";
        } catch (IllegalArgumentException e) {
            return "err " + e.getMessage();
        }
    }
}
