package org.dronemap.core.mission;

import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.stored.Stored;

/** Where a mission lets a vehicle land, and how high the ground is there. */
@Stored(names = "point ground")
public record LandingPlace(Geodetic point, Altitude ground) {
    /** On a ground as high as home's. */
    public static LandingPlace levelWithHome(Geodetic point) {
        return new LandingPlace(point, Altitude.aboveHome(0));
    }
}
