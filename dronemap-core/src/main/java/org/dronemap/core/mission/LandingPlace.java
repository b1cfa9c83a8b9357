package org.dronemap.core.mission;

import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.stored.Stored;

/** The place at which a mission lets a vehicle land, and the height of the ground there. */
@Stored(names = "point ground")
public record LandingPlace(Geodetic point, Altitude ground) {
    /** On a ground as high as home's. */
    public static LandingPlace levelWithHome(Geodetic point) {
        return new LandingPlace(point, Altitude.aboveHome(0));
    }
}
