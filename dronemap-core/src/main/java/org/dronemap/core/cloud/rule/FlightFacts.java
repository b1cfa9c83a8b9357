package org.dronemap.core.cloud.rule;

import java.util.Optional;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;

/** Tests on a drone's state, such as whether it flies, also for vehicles without arming or without modes. */
public final class FlightFacts {
    private FlightFacts() {}

    /** In the air with its motors on; ground vehicles never are. */
    public static boolean isFlying(DroneState state) {
        boolean runs = arms(state)
                ? Boolean.TRUE.equals(state.armed())
                : state.capabilities().known();
        return runs && CommandRules.needsAir(state) && state.airborne();
    }

    /** Known to be on the ground, with its motors off where it can say so. */
    public static boolean isDown(DroneState state) {
        return state.link().state() == LinkState.LIVE
                && (arms(state)
                        ? Boolean.FALSE.equals(state.armed())
                        : state.capabilities().known() && (!CommandRules.needsAir(state) || state.isOnGround()));
    }

    /** It flies, or drives, by itself until its mission is over. */
    public static boolean isInMission(DroneState state) {
        return state.capabilities().steering(state.mode()).equals(Optional.of(Steering.MISSION))
                && !state.mission().complete();
    }

    /** By a pilot's sticks. */
    public static boolean isSteeredManually(DroneState state) {
        return state.capabilities().steering(state.mode()).equals(Optional.of(Steering.STICKS));
    }

    /**
     * Whether it can be told if it flies. One that fell silent since is not waited for: what is known of it would be old when it
     * is heard again, and a pilot may have it by then.
     */
    public static boolean areKnown(DroneState state) {
        boolean modes = !arms(state) || (state.mode() != null && state.armed() != null);
        return state.capabilities().known() && modes && (state.phase() != null || state.position() != null);
    }

    private static boolean arms(DroneState state) {
        return !state.capabilities().known() || state.capabilities().commands().contains(Capability.ARM);
    }
}
