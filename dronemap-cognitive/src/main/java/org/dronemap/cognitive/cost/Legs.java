package org.dronemap.cognitive.cost;

/**
 * Flying time, length and energy of the legs between the numbered places of a planning problem. Places are numbered:
 * the waypoints 0 to n-1, then of drone r its start n+2r and its end n+2r+1. Drones of one type fly alike, so that a
 * leg costs the same for all of them. Ways may differ there and back (wind, climbs). Safe for several threads.
 */
public interface Legs {
    /** Waypoints and two places a drone. */
    int places();

    /** How far east a place lies, on a flat map that is right enough to tell what lies near. */
    double eastMeters(int place);

    /** How far north a place lies, on the same map. */
    double northMeters(int place);

    /** Flying time without service at either place, at least 0; infinite where no way leads. */
    double seconds(int type, int from, int to);

    /** Length of the way flown, at least 0. */
    double meters(int type, int from, int to);

    /** Energy drawn on the way, at least 0. */
    double joules(int type, int from, int to);
}
