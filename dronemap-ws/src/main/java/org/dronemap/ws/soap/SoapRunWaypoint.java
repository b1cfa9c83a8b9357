package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.ws.service.RunView;
import org.jspecify.annotations.Nullable;

/** One waypoint of a mission run; {@code state} as in REST. */
@SuppressWarnings("UnusedVariable") // JAXB reads the fields
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "runWaypoint",
        namespace = Namespace.URI,
        propOrder = {"waypoint", "state", "droneId", "why", "task"})
public class SoapRunWaypoint {
    private String waypoint = "";
    private String state = "";
    private @Nullable String droneId;
    private @Nullable String why;
    private List<SoapRunTask> task = new ArrayList<>();

    static SoapRunWaypoint of(RunView.WaypointView view) {
        SoapRunWaypoint waypoint = new SoapRunWaypoint();
        waypoint.waypoint = view.id();
        waypoint.state = view.state();
        waypoint.droneId = view.drone();
        waypoint.why = view.why();
        waypoint.task =
                new ArrayList<>(view.tasks().stream().map(SoapRunTask::of).toList());
        return waypoint;
    }

    public String getWaypoint() {
        return waypoint;
    }

    public String getState() {
        return state;
    }
}
