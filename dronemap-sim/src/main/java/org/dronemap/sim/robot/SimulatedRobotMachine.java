package org.dronemap.sim.robot;

import java.util.Map;
import tools.jackson.databind.JsonNode;

/**
 * A simulated robot without its bridge, such as a rover: moves, gives the content of reports, and carries out orders.
 * Owned by the fleet's thread.
 */
interface SimulatedRobotMachine {
    /** The number of its kind in heartbeats. */
    int type();

    void move(double seconds);

    /** Where it truly is, and how fast: metres and m/s. */
    SimulatedRobotFleet.GroundTruth truth();

    Map<String, Object> status();

    Map<String, Object> motion();

    /** By the number of the message, further ones that are sent now and then. */
    Map<Integer, Map<String, Object>> images();

    /** The answer to a question for its map; empty where it has none. */
    Map<String, Object> map();

    void execute(int order, JsonNode body);

    /** Nobody is there any more who would stop it: makes itself safe. */
    void cloudLost();
}
