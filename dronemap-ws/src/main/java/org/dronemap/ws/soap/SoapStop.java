package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import org.dronemap.ws.service.PlanView;

/** A visit of a plan; seconds after its start. */
@SuppressWarnings("UnusedVariable") // JAXB reads the fields
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "stop",
        namespace = Namespace.URI,
        propOrder = {"waypoint", "latitude", "longitude", "altitudeAmsl", "arrivesSeconds", "leavesSeconds"})
public class SoapStop {
    private String waypoint = "";
    private double latitude;
    private double longitude;
    private double altitudeAmsl;
    private double arrivesSeconds;
    private double leavesSeconds;

    static SoapStop of(PlanView.StopView view) {
        SoapStop stop = new SoapStop();
        stop.waypoint = view.waypoint();
        stop.latitude = view.latitude();
        stop.longitude = view.longitude();
        stop.altitudeAmsl = view.altitudeAmsl();
        stop.arrivesSeconds = view.arrivesSeconds();
        stop.leavesSeconds = view.leavesSeconds();
        return stop;
    }

    public String getWaypoint() {
        return waypoint;
    }
}
