package org.dronemap.sim.robot;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;

/** A deviation from the ROSLink protocol of bridges in the field, which simulated robots can imitate. */
public enum BridgeQuirk {
    /** Drives on with the last speeds that it heard, for ever; without, it stops half a second after them. */
    REPEATS_TWIST,
    /** Its key is a JSON number. */
    NUMBER_KEY,
    /** Its owner's id is a text. */
    TEXT_OWNER,
    /** Sends the body of a heartbeat where a status is due. */
    STATUS_IS_HEARTBEAT,
    /** Counts each kind of message by itself, and from 1 again after 15,000. */
    COUNTS_EACH_KIND,
    /** Sends its heartbeats over UDP as well where it has a WebSocket. */
    BEATS_ON_BOTH,
    /** Breaks the lines of its pictures, as MIME does. */
    BROKEN_LINES,
    /** Header fields outside, the body under "payload". */
    PAYLOAD_SHAPE,
    /** After an emergency stop it listens to nothing any more. */
    DIES_OF_STOP,
    /** Listens to nothing at all. */
    IGNORES_ORDERS;

    static Set<BridgeQuirk> of(String text) {
        Set<BridgeQuirk> quirks = EnumSet.noneOf(BridgeQuirk.class);
        for (String name : text.split(",", -1)) {
            if (!name.isBlank()) {
                quirks.add(named(name.strip()));
            }
        }
        return quirks;
    }

    private static BridgeQuirk named(String name) {
        return Arrays.stream(values())
                .filter(quirk -> quirk.label().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("--quirks knows no '" + name + "': say --help"));
    }

    /** As it is written on a command line. */
    public String label() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
