package org.dronemap.ws.flights.separation;

import java.util.List;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;

/** One operation of a scenario, which may be flown in any laboratory: alone, or beside others. */
interface Party {
    String name();

    List<Spot> pads();

    List<Spot> waypoints();

    /** All waypoints are to be passed. */
    default boolean isFlownToItsEnd() {
        return true;
    }

    /** Puts its vehicles down and prepares all that may be done before it begins; time goes by. */
    Flight prepared(Laboratory lab);

    /** An operation in a laboratory. */
    interface Flight {
        List<LabDrone> drones();

        /** No time goes by. */
        void begin();

        /** It has been begun, and nothing more will come of it. */
        boolean isOver();

        /** Seconds after its beginning from which on it is to meet others; asked once it is over. */
        default double meetsAfter() {
            return 0;
        }

        /** Looked at ten times a second once it has begun, for what is done in the course of it. */
        default void step() {}
    }
}
