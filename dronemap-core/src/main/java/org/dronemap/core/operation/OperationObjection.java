package org.dronemap.core.operation;

import java.util.List;
import org.dronemap.core.operation.Objection.Subject;

/** Reasons why no operation, of whichever kind, takes a wish. */
public enum OperationObjection implements ObjectionCode {
    OVER("operation-over", "The mission run or follow has ended.", "This mission run is over."),
    NOT_CONDUCTED(
            "operation-not-conducted",
            "A fault of the server: it does not conduct operations of this kind.",
            "The cloud does not conduct operations of the kind run: a fault of its own, which is logged for its makers.");

    private final String word;
    private final String meaning;
    private final String example;

    @SuppressWarnings("ImmutableEnumChecker") // never changes
    private final List<Subject> subjects;

    OperationObjection(String word, String meaning, String example, Subject... subjects) {
        this.word = word;
        this.meaning = meaning;
        this.example = example;
        this.subjects = List.of(subjects);
    }

    @Override
    public String word() {
        return word;
    }

    @Override
    public String meaning() {
        return meaning;
    }

    @Override
    public String example() {
        return example;
    }

    @Override
    public List<Subject> subjects() {
        return subjects;
    }
}
