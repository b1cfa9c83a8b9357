package org.dronemap.cognitive.operation.run.model;

import org.dronemap.core.operation.Objection.Subject;
import org.dronemap.core.operation.ObjectionCode;
import org.dronemap.core.operation.ObjectionEntry;

/** Codes of the reasons why a mission run cannot do now what a user asks. */
public enum RunObjection implements ObjectionCode {
    STOPPING(
            "run-stopping",
            "The mission run is being stopped; its drones fly home.",
            "The mission run is being stopped."),
    PAUSED("run-paused", "The mission run is paused already.", "The mission run is paused already."),
    NOT_PAUSED("run-not-paused", "The mission run is not paused.", "The mission run is not paused."),
    NO_PROPOSAL(
            "run-proposal-unknown",
            "No proposal of this number waits for an answer.",
            "There is no proposal 3 that waits for an answer.",
            Subject.PROPOSAL),
    DRONE_NOT_IN_RUN(
            "run-without-drone",
            "The drone is not part of the mission run.",
            "The drone is no part of the run.",
            Subject.DRONE),
    DRONE_IN_RUN(
            "run-has-drone",
            "The drone is part of the mission run already.",
            "The drone is part of the run.",
            Subject.DRONE),
    DRONE_NOT_RESUMABLE(
            "run-drone-not-resumable",
            "The drone flies for the mission run.",
            "Kestrel does not wait for being resumed.",
            Subject.DRONE),
    DRONE_OUT(
            "run-drone-out",
            "The mission run does not count on the drone any more.",
            "Kestrel is out of the run already.",
            Subject.DRONE),
    DRONES_FULL(
            "run-drones-full",
            "The mission run has as many drones as it may have.",
            "A run has 100 drones at most.",
            Subject.MOST),
    WAYPOINTS_FULL(
            "run-waypoints-full",
            "The mission run would have more waypoints than it may have.",
            "One waypoint at least is added, and a run has 100000 at most.",
            Subject.MOST),
    ZONES_FULL(
            "run-zones-full",
            "Zones of the mission run would have more corners than ways can be found between.",
            "That is more zones than ways can be found between.",
            Subject.MOST),
    NO_WAYPOINT(
            "run-without-waypoint",
            "The mission run has no waypoint of this id.",
            "The run has no waypoint w7.",
            Subject.WAYPOINT),
    WAYPOINT_SETTLED(
            "run-waypoint-settled",
            "The waypoint was visited or cancelled, or nobody visits it.",
            "The waypoint w7 is settled: visited.",
            Subject.WAYPOINT,
            Subject.STATE),
    WAYPOINT_KNOWN(
            "run-has-waypoint",
            "The mission run has a waypoint of this id already.",
            "There is a waypoint w7 already.",
            Subject.WAYPOINT),
    TOO_FAR(
            "run-place-too-far",
            "The place is too far from the drones of the mission run.",
            "That place is more than 100 km away.",
            Subject.MOST);

    @SuppressWarnings("ImmutableEnumChecker") // its list never changes
    private final ObjectionEntry entry;

    RunObjection(String word, String meaning, String example, Subject... subjects) {
        entry = ObjectionEntry.of(word, meaning, example, subjects);
    }

    @Override
    public ObjectionEntry entry() {
        return entry;
    }
}
