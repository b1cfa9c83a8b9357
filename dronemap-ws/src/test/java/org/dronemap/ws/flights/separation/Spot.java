package org.dronemap.ws.flights.separation;

import org.dronemap.core.geo.Geodetic;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.ws.lab.LabDrone;

/** A place in metres north, east and above the corner of the laboratory's field. */
record Spot(double north, double east, double up) {
    LocalFrame frame() {
        return LabDrone.FIELD.shifted(new NeuPosition(north, east, up));
    }

    Geodetic place() {
        NeuPosition here = new NeuPosition(north, east, up);
        return new Geodetic(LabDrone.FIELD.latitudeOf(here), LabDrone.FIELD.longitudeOf(here));
    }

    double amsl() {
        return LabDrone.FIELD.altitudeAmsl() + up;
    }

    double metersOverGroundTo(Spot other) {
        return Math.hypot(north - other.north, east - other.east);
    }

    static Spot of(Geodetic place, double amsl) {
        double up = amsl - LabDrone.FIELD.altitudeAmsl();
        NeuPosition here = LabDrone.FIELD.locate(place.latitudeDegrees(), place.longitudeDegrees(), up);
        return new Spot(here.north(), here.east(), up);
    }
}
