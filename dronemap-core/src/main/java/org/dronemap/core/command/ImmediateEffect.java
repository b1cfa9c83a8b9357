package org.dronemap.core.command;

/**
 * Immediate effect of a command on its drone's motion, such as climb, turn or go to a point; used by safety rules.
 * Zones, the state of the drone and whoever watches modes judge a command by this, without a default.
 */
public enum ImmediateEffect {
    /** It goes on with what it is at, in the mode that it is in. */
    NONE,
    /** It stands still, or may do so while something is written to it. */
    STANDS,
    /** It turns on the spot. */
    TURNS,
    /** It goes on with what it is at, faster or slower: a {@link ChangeSpeed}. */
    CHANGES_SPEED,
    /** It goes straight up: a {@link Command.TakeOff}. */
    CLIMBS,
    /** It goes to a place on Earth: a {@link Command.GoTo}. */
    GOES,
    /** It goes to a place of its own map, and nobody knows where that is on Earth. */
    GOES_ON_ITS_MAP,
    /** It gets a mission to fly later, and may stand still meanwhile: a {@link Command.UploadMission}. */
    TAKES_MISSION,
    /** It flies the mission that it has. */
    FLIES_MISSION,
    /** It goes by another mode: a {@link Command.SetMode}. */
    CHANGES_MODE,
    /** It comes home, or down: no zone keeps it from that. */
    COMES_DOWN
}
