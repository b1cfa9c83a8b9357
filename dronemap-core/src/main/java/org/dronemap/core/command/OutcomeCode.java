package org.dronemap.core.command;

import java.util.EnumSet;
import java.util.Set;
import org.dronemap.core.stored.Stored;
import org.dronemap.core.stored.StoredNames;

/**
 * Stable code for why a command did not succeed, for programs; a sentence for people comes with it. What a word is
 * stored as is what programs read.
 */
@Stored(
        names =
                "drone-not-of-key role-may-not-command key-may-not-command command-not-granted "
                        + "not-disarmed-for-planner drone-is-a-recording contact-lost capabilities-unknown "
                        + "capability-missing already-armed not-armed drone-airborne not-airborne mission-missing "
                        + "mode-unknown mode-not-steerable heading-unknown home-unknown place-too-far zone-forbids "
                        + "zone-not-checkable key-bounds-forbid key-bounds-not-checkable control-held control-ended command-under-way transfer-under-way link-missing "
                        + "server-overloaded not-sent not-written-down drone-removed server-fault autopilot-unknown not-settable command-refused "
                        + "vehicle-busy vehicle-denied vehicle-does-not-know vehicle-failed vehicle-cancelled "
                        + "positions-not-taken mission-item-not-known mission-too-long mission-value-not-taken "
                        + "mission-out-of-order vehicle-refused command-failed command-timed-out command-superseded "
                        + "outcome-unknown speed-not-possible mode-does-not-arm position-missing fence-forbids mission-not-for-vehicle")
public enum OutcomeCode {
    DRONE_NOT_OF_KEY("The access key is for other drones.", "This access key is for other drones."),
    ROLE_MAY_NOT_COMMAND(
            "The role may not give commands of this kind.",
            "Your role may plan, not fly; ask an administrator for the operator role."),
    KEY_MAY_NOT_COMMAND("The access key may not give commands of this kind.", "This access key may not command."),
    COMMAND_NOT_GRANTED(
            "The role would do, but this was not granted with this drone.",
            "You were not granted to command this drone."),
    NOT_DISARMED_FOR_PLANNER(
            "Who plans changes what is on board only while the drone is known to be disarmed.",
            "A planner may change what a drone carries only while it is known to be disarmed."),
    DRONE_IS_A_RECORDING("The drone is played from a recording.", "This is a recording; it cannot be commanded."),
    CONTACT_LOST("The drone is not heard.", "There is no contact with the drone; a command would not reach it."),
    CAPABILITIES_UNKNOWN(
            "What the vehicle can do is not known yet.",
            "It is not known yet what this vehicle can do; try again in a moment."),
    CAPABILITY_MISSING("The vehicle cannot do this at all.", "This vehicle (a rover of ArduPilot) cannot take off."),
    ALREADY_ARMED("The drone is armed already.", "It is already armed."),
    NOT_ARMED("The drone is not armed.", "Arm first."),
    DRONE_AIRBORNE("The drone is in the air.", "It is in the air; land first."),
    NOT_AIRBORNE("The drone is on the ground.", "Take off first."),
    MISSION_MISSING("There is no mission on board.", "Upload a mission first."),
    MODE_UNKNOWN(
            "The vehicle has no mode of this name.", "This vehicle has no mode SPIRAL; it knows STABILIZE, GUIDED."),
    MODE_NOT_STEERABLE(
            "In its mode the drone does not go by what it is steered with.",
            "In AUTO it is not to be steered so; change its mode to GUIDED first."),
    HEADING_UNKNOWN(
            "Where the drone looks is not known.",
            "Where it looks is not known; steer it by its own forward and right."),
    HOME_UNKNOWN("Where the drone's home is, is not known.", "The home of this vehicle is not known."),
    PLACE_TOO_FAR(
            "The place is farther away than a drone is sent at one go.",
            "47.00000, 8.00000 is 300 km from where it is; it is sent at most 100 km far."),
    ZONE_FORBIDS(
            "A zone forbids the way.",
            "The way from where the drone is to the place enters the no-fly zone “Airport” after 445 m."),
    ZONE_NOT_CHECKABLE(
            "A zone binds the drone, and nobody can tell whether the way keeps to it.",
            "The way there is longer than 1000 km; it cannot be checked against the zone “Airport”."),
    KEY_BOUNDS_FORBID(
            "The way leaves the area or heights of the access key, or the key's bounds let nobody change this.",
            "The way there leaves the bounds of this access key after 120 m."),
    KEY_BOUNDS_NOT_CHECKABLE(
            "The access key has an area or heights, and nobody can tell whether the way keeps to them.",
            "Where it flies in CIRCLE is not known; so it cannot be checked against the bounds of this access key."),
    CONTROL_HELD(
            "Somebody else has control of the drone.",
            "mia has had control of it since 2026-03-04 05:06:07 UTC; ask for it, or wait until it is given back."),
    CONTROL_ENDED(
            "The control that is named by its epoch has ended.",
            "Control by epoch 101 has ended. Nobody has control; take it."),
    COMMAND_UNDER_WAY(
            "Another command to the drone has to end first.",
            "Wait for the end of what is under way: take off to 10 m."),
    TRANSFER_UNDER_WAY(
            "Another mission, or the like, is on its way to the drone or from it.",
            "Another mission transfer with this drone is under way; wait for its end."),
    LINK_MISSING("There is no link over which it could be sent.", "There is no link to the drone."),
    SERVER_OVERLOADED("The server had too much to do to send it.", "The server is overloaded; nothing was sent."),
    NOT_SENT(
            "The server stopped before it was sent.",
            "It was not sent: the server stopped, or could not write it down, before."),
    NOT_WRITTEN_DOWN(
            "It was not sent, since it could not be written down, as is done before.",
            "It was not sent: the server stopped, or could not write it down, before."),
    DRONE_REMOVED("The drone was removed before it was sent.", "It was not sent: there is no such drone any more."),
    SERVER_FAULT(
            "A fault of the server: it cannot judge or do what was asked.",
            "The cloud does not know how to do this: a fault of its own, which is logged for its makers."),
    AUTOPILOT_UNKNOWN(
            "How vehicles of this autopilot are commanded is not known here.",
            "The ways of this autopilot (MWC) are not known here; nothing was sent."),
    NOT_SETTABLE("The vehicle has no setting for this.", "How high this vehicle flies home cannot be set."),
    COMMAND_REFUSED(
            "It was refused before it had an effect, in a way that has no code of its own.", "It is not armed."),
    VEHICLE_BUSY("The vehicle cannot do this now; it may later.", "The vehicle cannot do that at the moment."),
    VEHICLE_DENIED("The vehicle does not do this as it is now.", "The vehicle denied it and gave no reason."),
    VEHICLE_DOES_NOT_KNOW(
            "The vehicle does not know such a command, or not in this form.",
            "The vehicle does not know this command."),
    VEHICLE_FAILED("The vehicle tried and could not.", "The vehicle could not do it and gave no reason."),
    VEHICLE_CANCELLED("It was cancelled on the vehicle.", "The command was cancelled on the vehicle."),
    POSITIONS_NOT_TAKEN(
            "The vehicle does not take positions of this kind.", "The vehicle does not take positions of this kind."),
    MISSION_ITEM_NOT_KNOWN(
            "The vehicle does not know a kind of item of the mission.",
            "The vehicle does not know an item of this mission."),
    MISSION_TOO_LONG("The vehicle has no room for the mission.", "The vehicle has no room for so many mission items."),
    MISSION_VALUE_NOT_TAKEN(
            "The vehicle finds a value of the mission invalid.",
            "The vehicle finds a value of the mission invalid (result 5)."),
    MISSION_OUT_OF_ORDER(
            "The vehicle got the items in another order than it asked for.",
            "The vehicle got the mission items out of order."),
    VEHICLE_REFUSED(
            "The vehicle answered with an error that has no code of its own.", "The vehicle answered with result 12."),
    COMMAND_FAILED("It was accepted, but did not come about; the sentence tells why.", "It was armed meanwhile."),
    COMMAND_TIMED_OUT("There was no answer in the time that the sentence tells.", "It was not done within 5 s."),
    COMMAND_SUPERSEDED(
            "A newer command, or another user, took its place.",
            "Control has changed hands. Nobody has control; take it."),
    OUTCOME_UNKNOWN(
            "It may or may not have acted, and nobody can tell any more.",
            "The vehicle accepted it, but has not said what it does since."),
    SPEED_NOT_POSSIBLE(
            "A vehicle of this kind does not go at this speed.",
            "metersPerSecond must be 0.2 to 30 for a vehicle of this kind (multicopter), not 45."),
    MODE_DOES_NOT_ARM(
            "The vehicle is not armed in its mode.",
            "Arm: RTL mode not armable. It is not armed in RTL; change its mode to GUIDED first."),
    POSITION_MISSING(
            "The vehicle does not know well enough where it is.",
            "Mode change to LOITER failed: requires position. Without a position it can land, or keep its height in"
                    + " ALT_HOLD while a pilot steers."),
    FENCE_FORBIDS(
            "The vehicle's own fence keeps it from going there.",
            "The vehicle denied it and gave no reason. The place is 240 m from its home, and its own fence ends at"
                    + " FENCE_RADIUS 150 m."),
    MISSION_NOT_FOR_VEHICLE(
            "An item of the mission is none that this vehicle flies, or has a value that it does not take.",
            "Item 2 (waypoint): this vehicle (ArduPlane) does not wait at a waypoint; \"holdSeconds\" must be 0, not 5.0.");

    private static final Set<OutcomeCode> AFTERWARDS = EnumSet.range(VEHICLE_BUSY, OUTCOME_UNKNOWN);

    private final String meaning;
    private final String example;

    OutcomeCode(String meaning, String example) {
        this.meaning = meaning;
        this.example = example;
    }

    /** Small letters with hyphens, such as {@code not-armed}. */
    public String word() {
        return StoredNames.of(this);
    }

    /** Told by the cloud, before anything had an effect; the others are known only when something was sent. */
    public boolean isOfTheGate() {
        return !AFTERWARDS.contains(this);
    }

    /** One line. */
    public String meaning() {
        return meaning;
    }

    /** A sentence that is told with it. */
    public String example() {
        return example;
    }
}
