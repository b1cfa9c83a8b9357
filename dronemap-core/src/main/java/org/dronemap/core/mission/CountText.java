package org.dronemap.core.mission;

/** Writes a count with its noun for people: "1 item", "4 items". */
public final class CountText {
    private CountText() {}

    /** "1 item", "4 items". */
    public static String of(int count, String noun) {
        return count + " " + noun + (count == 1 ? "" : "s");
    }
}
