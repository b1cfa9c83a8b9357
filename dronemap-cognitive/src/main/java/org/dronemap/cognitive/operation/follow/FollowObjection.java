package org.dronemap.cognitive.operation.follow;

import org.dronemap.core.operation.Objection.Subject;
import org.dronemap.core.operation.ObjectionCode;
import org.dronemap.core.operation.ObjectionEntry;

/** Codes of the reasons why a follow cannot do what a user asks at its present stage. */
public enum FollowObjection implements ObjectionCode {
    RETURNING("follow-returning", "The drone of the follow flies home.", "The drone is on its way home already."),
    NOT_STARTED(
            "follow-not-started",
            "The follow has a drone, which was not told to start.",
            "It has not been started: start it, or cancel it."),
    STARTING("follow-starting", "The drone of the follow is taking off.", "The drone is taking off already."),
    STARTED(
            "follow-started",
            "The drone of the follow has taken off before, and follows.",
            "The drone follows already."),
    PAUSED("follow-paused", "The follow is paused already.", "It is paused already."),
    NOT_PAUSED("follow-not-paused", "The follow goes on; nothing holds it.", "It is not paused."),
    SUSPENDED(
            "follow-suspended",
            "Somebody else has the drone of the follow.",
            "Somebody else has the drone: it does not follow."),
    NOT_RELIEVABLE(
            "follow-not-relievable",
            "The drone of the follow need not be replaced.",
            "Nobody has to replace Kestrel now."),
    HAS_DRONE(
            "follow-has-drone",
            "The drone that would replace another one is part of the follow already.",
            "Nobody has to replace Kestrel now.");

    @SuppressWarnings("ImmutableEnumChecker") // its list never changes
    private final ObjectionEntry entry;

    FollowObjection(String word, String meaning, String example, Subject... subjects) {
        entry = ObjectionEntry.of(word, meaning, example, subjects);
    }

    @Override
    public ObjectionEntry entry() {
        return entry;
    }
}
