package org.dronemap.core.mission;

/** Counts as people say them. */
public final class CountText {
    private CountText() {}

    /** "1 item", "4 items". */
    public static String of(int count, String noun) {
        return count + " " + noun + (count == 1 ? "" : "s");
    }
}
