package org.dronemap.cognitive.operation.recovery;

import org.dronemap.core.operation.Objection.Subject;
import org.dronemap.core.operation.ObjectionCode;
import org.dronemap.core.operation.ObjectionEntry;

/** Codes of the reasons why a recovery cannot do what a user asks at its present stage. */
public enum RecoveryObjection implements ObjectionCode {
    GIVING_BACK(
            "recovery-giving-back",
            "The recovery was called off before; its drones go over to whoever asked for it.",
            "It was called off already; its drones hold, and control goes over.");

    @SuppressWarnings("ImmutableEnumChecker") // its list never changes
    private final ObjectionEntry entry;

    RecoveryObjection(String word, String meaning, String example, Subject... subjects) {
        entry = ObjectionEntry.of(word, meaning, example, subjects);
    }

    @Override
    public ObjectionEntry entry() {
        return entry;
    }
}
