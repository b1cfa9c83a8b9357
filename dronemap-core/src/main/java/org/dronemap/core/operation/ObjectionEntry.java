package org.dronemap.core.operation;

import java.util.List;

/**
 * Documentation of one ObjectionCode in the catalogue of problems: word, meaning and example.
 *
 * @param word small letters with hyphens, such as {@code operation-over}; it never changes
 * @param meaning one line
 * @param example a sentence that is told with it
 * @param subjects those that are told each time, beside what was to be changed
 */
public record ObjectionEntry(String word, String meaning, String example, List<Objection.Subject> subjects) {
    public ObjectionEntry {
        subjects = List.copyOf(subjects);
    }

    public static ObjectionEntry of(String word, String meaning, String example, Objection.Subject... subjects) {
        return new ObjectionEntry(word, meaning, example, List.of(subjects));
    }
}
