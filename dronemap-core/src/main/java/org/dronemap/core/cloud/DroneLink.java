package org.dronemap.core.cloud;

import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.cloud.lane.LinkPace;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.LinkReport;
import org.dronemap.core.event.DroneEvent;

/**
 * A vehicle session's handle on its drone, through which it reports messages, events and link quality. Call {@code
 * heard} and {@code accept} on the lane only.
 */
public interface DroneLink {
    DroneId id();

    /** The owner thread of this drone. */
    Lane lane();

    /** True when the drone was removed, or answers to a newer session: connect again. On the lane only. */
    boolean isGone();

    /** Any valid message came in. */
    default void received() {
        received(LinkPace.UNCHANGED);
    }

    /** Any valid message came in, which shows at which pace the vehicle speaks. */
    void received(LinkPace pace);

    /** News; counts as heard. */
    void accept(DroneEvent event);

    /** How the vehicle is reached now, and how well; no sign of life by itself. On the lane only. */
    void linkChanged(LinkReport report);

    /** It has shown something of its own only after it was bound. On the lane only. */
    void proved(IdentityProof proof);

    /**
     * What spoke is a part of a vehicle for which another session speaks, such as a computer beside the autopilot: the
     * drone is that vehicle, whose hardware is to be told anew. Any thread.
     */
    void becamePart();

    /** What spoke turned out to be somebody else: a drone that was only made for it goes. Any thread. */
    void withdraw();

    /** The recording has been played to its end; silence from now on means nothing. On the lane only. */
    void replayEnded();

    /** The session has ended: a drone stays and falls silent, a replayed one goes. Any thread. */
    void disconnect();
}
