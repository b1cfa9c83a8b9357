package org.dronemap.sim.flight;

/** An event in the flight of a simulated vehicle: a text for the operator, or progress of its mission. */
public sealed interface FlightEvent {
    /** A sentence for the operator. */
    record Text(TextSeverity severity, String text) implements FlightEvent {}

    /** A mission item has begun. */
    record ItemStarted(int index, String type) implements FlightEvent {}

    /** A mission item has something done with what the vehicle carries. */
    record Ordered(SimulatedMissionItem order) implements FlightEvent {}

    /** It has come to where a mission item is, and may have to wait there. */
    record ItemArrived(int index) implements FlightEvent {}

    /** A mission item is done. */
    record ItemReached(int index) implements FlightEvent {}

    /** No item is left. */
    record MissionEnded() implements FlightEvent {}
}
