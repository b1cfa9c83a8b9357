package org.dronemap.core.operation;

import java.time.Instant;

/**
 * One journal entry of an operation: an input and the decision on it, as text.
 *
 * @param number counts from 0; the input of the first one is the state that it began with, and its decision is empty
 */
public record JournalEntry(long number, Instant at, String input, String decision) {
    private static final String SET_ASIDE = "\"set aside: ";

    public JournalEntry {
        if (number < 0) {
            throw new IllegalArgumentException("entries count from 0: " + number);
        }
    }

    /**
     * An operation is not conducted any more, whatever its kind would have decided: no machine took part in this entry, and
     * none follows but of its kind. The input is a text in JSON, as all inputs are.
     */
    public static JournalEntry settingAside(long number, Instant at, String why) {
        return new JournalEntry(number, at, SET_ASIDE + why.replaceAll("[\\p{Cntrl}\"\\\\]", " ") + "\"", "");
    }

    public boolean setsAside() {
        return input.startsWith(SET_ASIDE);
    }
}
