package org.dronemap.core.separation;

import org.dronemap.core.geo.PlanePoint;

/**
 * Region where a drone may be at one moment: on a disc round a spot, in a range of heights above sea level, in metres.
 *
 * @param reach radius of the disc; 0: at the spot
 */
record TrackSample(PlanePoint spot, double low, double high, double reach) {
    TrackSample(PlanePoint spot, double meters) {
        this(spot, meters, meters, 0);
    }

    TrackSample at(double reachMeters, double lower, double higher) {
        return new TrackSample(spot, lower, higher, reachMeters);
    }
}
