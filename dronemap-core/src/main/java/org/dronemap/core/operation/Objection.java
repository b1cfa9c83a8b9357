package org.dronemap.core.operation;

import java.util.Arrays;
import java.util.List;

/**
 * Objection of an operation to a user's request: a code for programs and a sentence for people.
 *
 * @param about exactly what the code declares, in its order
 */
public record Objection(ObjectionCode code, String sentence, List<About> about) {
    /** A thing that an objection is about. */
    public enum Subject {
        /** Id of a drone. */
        DRONE,
        /** Id of a waypoint. */
        WAYPOINT,
        /** The state of that waypoint: visited, cancelled or unserved. */
        STATE,
        /** Number of a proposal. */
        PROPOSAL,
        /** The most that is allowed, in the unit of the sentence. */
        MOST;

        public About is(String value) {
            return new About(this, value);
        }

        public About is(long value) {
            return new About(this, value);
        }
    }

    /** A subject with its value, a text or a whole number. */
    public record About(Subject subject, Object value) {
        public About {
            boolean isNumber = subject == Subject.PROPOSAL || subject == Subject.MOST;
            if (isNumber ? !(value instanceof Long) : !(value instanceof String)) {
                throw new IllegalArgumentException(subject + " is not told as " + value.getClass());
            }
        }
    }

    public Objection {
        about = List.copyOf(about);
        ObjectionEntry entry = code.entry();
        if (!about.stream().map(About::subject).toList().equals(entry.subjects())) {
            throw new IllegalArgumentException(
                    "\"" + entry.word() + "\" is told with " + entry.subjects() + ", not with " + about);
        }
    }

    public static Objection of(ObjectionCode code, String sentence, About... about) {
        return new Objection(code, sentence, Arrays.asList(about));
    }
}
