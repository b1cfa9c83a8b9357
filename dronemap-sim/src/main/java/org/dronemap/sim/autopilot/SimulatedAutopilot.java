package org.dronemap.sim.autopilot;

import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.sim.autopilot.items.MissionItemStorage;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedParameters;
import org.jspecify.annotations.Nullable;

/**
 * A simulated autopilot (ArduCopter or PX4): the commands it accepts, its flight modes and fail-safes. Owned by the
 * fleet's thread.
 */
public interface SimulatedAutopilot {
    /** Flies on to {@code nowMillis} of the vehicle's clock. */
    void step(long nowMillis, double seconds);

    SimulatedCommandResult execute(MavCommand order);

    SimulatedCommandResult setMode(int baseMode, long customMode);

    /** SET_MODE is acknowledged by some autopilots as if it were a command. */
    boolean acknowledgesSetMode();

    void steer(SetPositionTargetGlobalInt target);

    /** Speeds; an autopilot that flies by none takes no notice. */
    default void steer(SetPositionTargetLocalNed target) {}

    /** Sticks of a ground station; an autopilot that flies by none takes no notice. */
    default void manual(ManualControl sticks, int fromSystem) {}

    /** The throttle stick of the remote control, 1000 to 2000. */
    void stick(int throttle);

    /** A heartbeat of the ground station that the fail-safe listens to. */
    void heartbeatReceived(int systemId);

    Heartbeat heartbeat();

    /** MAV_LANDED_STATE. */
    int landedState();

    /** MAV_VTOL_STATE; 0 of a vehicle that has not both wings and lift motors. */
    default int vtolState() {
        return 0;
    }

    boolean readyToArm();

    SimulatedCraft craft();

    SimulatedMission plan();

    SimulatedPayload payload();

    /** One picture; the answer is what it says of it. */
    Message takePicture();

    SimulatedParameters parameters();

    /** A new signing key is taken in flight as well. */
    boolean acceptsKeysWhenArmed();

    /** Integer parameters travel as their bits in the float. */
    boolean parametersAsBits();

    /** A parameter has been written. */
    void parameterChanged(String name);

    /** Commands for a component that is not there are acted on. */
    boolean heedsEveryComponent();

    /** What is answered when somebody wants a rate for a message that it does not have. */
    SimulatedCommandResult refuseInterval(int messageId);

    MissionProtocolStyle missionStyle();

    /** Which mission items it takes, and what it keeps of them. */
    MissionItemStorage missionItems();

    FenceStorage fence();

    FenceStorage rallyPoints();

    /** A message that this kind of autopilot alone has; null when it has none of that number, or nothing to say. */
    default @Nullable Message own(int messageId) {
        return null;
    }

    /** The wire's number of the item that is flown or comes next. */
    int currentItem();

    /** MISSION_STATE: 1 no mission, 2 not started, 3 active, 4 paused, 5 complete. */
    int missionState();

    boolean inMissionMode();

    boolean setCurrentItem(int index);

    /** What it says when an item of its mission is reached; empty when it says nothing, or has said it itself. */
    default String reachedText(int index) {
        return "";
    }

    /** A mission may be cleared now. */
    boolean mayClearMission();

    /** The number of the mission in the plan, which another one never has; 0 when it numbers none. */
    long missionStamp();

    /** A new mission is in the plan. */
    void missionChanged();

    /** Firmware as in AUTOPILOT_VERSION: major, minor, patch and type in one number. */
    long firmware();

    /** Messages per second that flow before anybody has asked, by message number. */
    double unaskedRate(int messageId);
}
