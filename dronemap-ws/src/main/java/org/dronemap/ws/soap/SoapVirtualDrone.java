package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.ws.service.VirtualDroneView;
import org.jspecify.annotations.Nullable;

/** A virtual drone and its mission as it was last asked for; {@code state}, {@code link} and {@code flight} as in REST. */
@SuppressWarnings("UnusedVariable") // JAXB reads the fields
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "virtualDrone",
        namespace = Namespace.URI,
        propOrder = {
            "virtualDroneId",
            "name",
            "owner",
            "waypoint",
            "state",
            "sentence",
            "queuePosition",
            "flown",
            "total",
            "why",
            "droneId",
            "link",
            "flight",
            "latitude",
            "longitude",
            "altitudeAboveHome"
        })
public class SoapVirtualDrone {
    private String virtualDroneId = "";
    private String name = "";
    private String owner = "";
    private List<SoapWaypoint> waypoint = new ArrayList<>();
    private @Nullable String state;
    private @Nullable String sentence;
    private @Nullable Integer queuePosition;
    private @Nullable Integer flown;
    private @Nullable Integer total;
    private @Nullable String why;
    private @Nullable String droneId;
    private @Nullable String link;
    private @Nullable String flight;
    private @Nullable Double latitude;
    private @Nullable Double longitude;
    private @Nullable Double altitudeAboveHome;

    static SoapVirtualDrone of(VirtualDroneView view) {
        SoapVirtualDrone soap = new SoapVirtualDrone();
        soap.virtualDroneId = view.id();
        soap.name = view.name();
        soap.owner = view.owner();
        if (view.items() != null) {
            view.items().forEach(item -> soap.waypoint.add(SoapWaypoint.of(item)));
        }
        if (view.run() != null) {
            soap.fill(view.run());
        }
        if (view.live() != null) {
            soap.fill(view.live());
        }
        return soap;
    }

    private void fill(VirtualDroneView.RunView run) {
        state = run.state();
        sentence = run.sentence();
        queuePosition = run.queue() == null ? null : run.queue().position();
        flown = run.flown();
        total = run.total();
        why = run.why();
        droneId = run.drone() == null ? null : run.drone().id();
    }

    private void fill(VirtualDroneView.LiveView live) {
        link = live.link();
        flight = live.flight();
        if (live.position() != null) {
            latitude = live.position().latitude();
            longitude = live.position().longitude();
            altitudeAboveHome = live.position().altitudeAboveHome();
        }
    }

    public String getVirtualDroneId() {
        return virtualDroneId;
    }

    public String getName() {
        return name;
    }

    public List<SoapWaypoint> getWaypoint() {
        return List.copyOf(waypoint);
    }

    public @Nullable String getState() {
        return state;
    }

    public @Nullable String getDroneId() {
        return droneId;
    }

    public @Nullable Integer getQueuePosition() {
        return queuePosition;
    }
}
