package org.dronemap.core.operation;

import java.time.Instant;

/**
 * What befell an operation, and what it decided; the texts are its kind's own.
 *
 * @param number counts from 0; the input of the first one is the state that it began with, and its decision is empty
 */
public record JournalEntry(long number, Instant at, String input, String decision) {
    public JournalEntry {
        if (number < 0) {
            throw new IllegalArgumentException("entries count from 0: " + number);
        }
    }
}
