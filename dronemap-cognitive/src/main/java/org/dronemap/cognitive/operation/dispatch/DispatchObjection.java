package org.dronemap.cognitive.operation.dispatch;

import org.dronemap.core.operation.Objection.Subject;
import org.dronemap.core.operation.ObjectionCode;
import org.dronemap.core.operation.ObjectionEntry;

/** Codes of the reasons why a dispatch cannot do what a user asks at its present stage. */
public enum DispatchObjection implements ObjectionCode {
    RETURNING(
            "dispatch-returning",
            "The dispatch was called off or failed before; its drones fly home.",
            "It was called off already; what flew for it is on its way home."),
    NOT_SEARCHING("dispatch-has-drone", "No other drone is looked for.", "No other drone has to come now.");

    @SuppressWarnings("ImmutableEnumChecker") // its list never changes
    private final ObjectionEntry entry;

    DispatchObjection(String word, String meaning, String example, Subject... subjects) {
        entry = ObjectionEntry.of(word, meaning, example, subjects);
    }

    @Override
    public ObjectionEntry entry() {
        return entry;
    }
}
