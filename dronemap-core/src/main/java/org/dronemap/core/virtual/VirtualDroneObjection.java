package org.dronemap.core.virtual;

import org.dronemap.core.operation.Objection.Subject;
import org.dronemap.core.operation.ObjectionCode;
import org.dronemap.core.operation.ObjectionEntry;

/** Objection codes for why a virtual drone refuses a user's request, such as to start it without a mission. */
public enum VirtualDroneObjection implements ObjectionCode {
    NO_MISSION("virtual-drone-without-mission", "The virtual drone has no mission yet.", "Plan its mission first."),
    UNDER_WAY(
            "virtual-drone-under-way",
            "The virtual drone's mission is asked for, or flown.",
            "Its mission is under way already."),
    NOT_UNDER_WAY(
            "virtual-drone-not-under-way",
            "The virtual drone's mission is not flown, nor does it wait for a drone.",
            "Its mission is not under way."),
    NOT_SUSPENDED(
            "virtual-drone-not-suspended",
            "The virtual drone was neither suspended nor did it fail.",
            "It does not wait for being resumed."),
    DRONE_AWAY(
            "virtual-drone-awaits-drone",
            "A drone that served the virtual drone is still on its way home.",
            "A drone that served it is not back yet."),
    GONE(
            "virtual-drone-removed",
            "The virtual drone was removed meanwhile.",
            "There is no virtual drone v12345678901.");

    @SuppressWarnings("ImmutableEnumChecker") // its list never changes
    private final ObjectionEntry entry;

    VirtualDroneObjection(String word, String meaning, String example, Subject... subjects) {
        entry = ObjectionEntry.of(word, meaning, example, subjects);
    }

    @Override
    public ObjectionEntry entry() {
        return entry;
    }
}
