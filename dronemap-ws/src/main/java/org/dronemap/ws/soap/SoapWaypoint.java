package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import org.dronemap.ws.service.MissionItemView;
import org.jspecify.annotations.Nullable;

/** One step of a mission; with no type it is a waypoint. Degrees, metres, seconds. */
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "waypoint",
        namespace = Namespace.URI,
        propOrder = {
            "type",
            "latitude",
            "longitude",
            "altitude",
            "altitudeReference",
            "holdSeconds",
            "output",
            "pulse",
            "description"
        })
public class SoapWaypoint {
    private @Nullable String type;
    private @Nullable Double latitude;
    private @Nullable Double longitude;
    private @Nullable Double altitude;
    private @Nullable String altitudeReference;
    private @Nullable Double holdSeconds;
    private @Nullable Integer output;
    private @Nullable Integer pulse;
    private @Nullable String description;

    static SoapWaypoint of(MissionItemView item) {
        SoapWaypoint waypoint = new SoapWaypoint();
        waypoint.type = item.type();
        waypoint.latitude = item.latitude();
        waypoint.longitude = item.longitude();
        waypoint.altitude = item.altitude();
        waypoint.altitudeReference = item.altitudeReference();
        waypoint.holdSeconds = item.holdSeconds();
        waypoint.output = item.output();
        waypoint.pulse = item.pulse();
        waypoint.description = item.description();
        return waypoint;
    }

    MissionItemView view() {
        return new MissionItemView(
                type == null ? "waypoint" : type,
                latitude,
                longitude,
                altitude,
                altitudeReference,
                holdSeconds,
                output,
                pulse,
                description);
    }

    /** For callers in Java. */
    public static SoapWaypoint at(
            @Nullable Double latitude, @Nullable Double longitude, @Nullable Double altitudeAboveHome) {
        return of(
                new MissionItemView("waypoint", latitude, longitude, altitudeAboveHome, null, null, null, null, null));
    }

    public @Nullable String getType() {
        return type;
    }

    public @Nullable Double getLatitude() {
        return latitude;
    }

    public @Nullable Double getLongitude() {
        return longitude;
    }

    public @Nullable Double getAltitude() {
        return altitude;
    }
}
