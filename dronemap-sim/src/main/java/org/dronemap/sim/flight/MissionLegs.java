package org.dronemap.sim.flight;

/** Makes the manoeuvre by which a kind of simulated vehicle flies each item of its mission. */
public interface MissionLegs {
    /** It moves for this item, or waits; other items are carried out at once, or passed over. */
    default boolean flies(SimulatedMissionItem item) {
        return item.isFlown();
    }

    /** What it tells of an item that it stores and cannot do: that it has begun, and nothing of its end. */
    default FlightEvent passedOver(int index, SimulatedMissionItem item) {
        return new FlightEvent.ItemStarted(index, item.typeName());
    }

    /** {@code yaw} in radians is where a condition item had it look; NaN: nowhere in particular. */
    Manoeuvre legFor(SimulatedMissionItem item, SimulatedCraft craft, double yaw);

    /** How long it stays with an item that it has come to. */
    long holdMillis(SimulatedMissionItem item);

    /** What it does after the last item, which was flown as {@code last}. */
    Manoeuvre afterwards(SimulatedCraft craft, Manoeuvre last);
}
