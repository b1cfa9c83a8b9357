package org.dronemap.core.drone;

import org.jspecify.annotations.Nullable;

/**
 * Action that a vehicle takes by itself when it loses the cloud, and after how long.
 *
 * @param action in a few words, such as "it returns home"; "it goes on" when it does nothing
 * @param afterSeconds null: nothing, or not known when
 * @param note a sentence on what cannot be had otherwise; empty: nothing
 */
public record CloudLossAction(String action, @Nullable Double afterSeconds, String note, AtHome atHome) {
    /** Its way down at home, where its own mission may matter to that. */
    public enum AtHome {
        /** Its mission does not matter; what there is to say stands in the note. */
        AS_SAID,
        /** By the landing sequence of its mission alone. */
        BY_MISSION,
        /** It needs no landing sequence. */
        BY_ITSELF
    }

    /** Of a vehicle whose mission does not matter to that. */
    public CloudLossAction(String action, @Nullable Double afterSeconds, String note) {
        this(action, afterSeconds, note, AtHome.AS_SAID);
    }

    /** For people. */
    public String sentence() {
        String when = afterSeconds == null
                ? ""
                : afterSeconds == Math.rint(afterSeconds)
                        ? " after " + afterSeconds.longValue() + " s"
                        : " after " + afterSeconds + " s";
        return "When it does not hear the cloud any more, " + action + when + "." + (note.isEmpty() ? "" : " " + note);
    }
}
