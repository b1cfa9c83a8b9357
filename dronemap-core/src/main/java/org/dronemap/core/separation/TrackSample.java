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

    /** Heights first: most pairs are done with them. */
    boolean isNear(TrackSample other, Separation least) {
        return low - other.high < least.verticalMeters()
                && other.low - high < least.verticalMeters()
                && spot.distanceMeters(other.spot) - reach - other.reach < least.horizontalMeters();
    }

    TrackSample at(double reachMeters, double lower, double higher) {
        return new TrackSample(spot, lower, higher, reachMeters);
    }
}
