package org.dronemap.cognitive.operation.recovery;

import org.dronemap.core.separation.Separation;
import org.dronemap.core.stored.Stored;

/**
 * The order of a recovery: how its drones come down, and within which heights.
 *
 * @param lowestMeters above each drone's home: none flies home below
 * @param ceilingMeters above each drone's home: none flies home above
 * @param apart what is kept between any two of them
 */
@Stored(names = "manner lowestMeters ceilingMeters apart")
public record RecoveryOrder(RecoveryManner manner, double lowestMeters, double ceilingMeters, Separation apart) {
    public static final double LEAST_METERS = 5;
    public static final double MOST_METERS = 500;
    public static final double USUAL_LOWEST_METERS = 20;
    public static final double USUAL_CEILING_METERS = 120;
    /** More are brought home in two recoveries, one after the other. */
    public static final int MOST_DRONES = 30;

    /** Drones stand and fly not quite where they are wanted, and the guard in flight keeps a little more than is asked for. */
    private static final double ROOM_BESIDE_METERS = 3;

    private static final double ROOM_ABOVE_METERS = 1;

    /** {@code least}: what is kept between any two drones. */
    public static RecoveryOrder of(RecoveryManner manner, double lowestMeters, double ceilingMeters, Separation least) {
        Separation aimed = least.aimedFor();
        return new RecoveryOrder(
                manner,
                lowestMeters,
                ceilingMeters,
                new Separation(
                        aimed.horizontalMeters() + ROOM_BESIDE_METERS, aimed.verticalMeters() + ROOM_ABOVE_METERS));
    }
}
