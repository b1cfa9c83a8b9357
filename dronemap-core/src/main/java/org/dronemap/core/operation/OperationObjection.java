package org.dronemap.core.operation;

import org.dronemap.core.operation.Objection.Subject;

/** Objection codes common to all kinds of operations, such as that the operation has ended. */
public enum OperationObjection implements ObjectionCode {
    OVER("operation-over", "The mission run or follow has ended.", "This mission run is over."),
    NOT_CONDUCTED(
            "operation-not-conducted",
            "A fault of the server: it does not conduct operations of this kind.",
            "The cloud does not conduct operations of the kind run: a fault of its own, which is logged for its makers.");

    @SuppressWarnings("ImmutableEnumChecker") // its list never changes
    private final ObjectionEntry entry;

    OperationObjection(String word, String meaning, String example, Subject... subjects) {
        entry = ObjectionEntry.of(word, meaning, example, subjects);
    }

    @Override
    public ObjectionEntry entry() {
        return entry;
    }
}
