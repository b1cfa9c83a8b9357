package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import org.dronemap.ws.service.RunView;
import org.jspecify.annotations.Nullable;

/** One drone of a mission run; {@code stage} as in REST. */
@SuppressWarnings("UnusedVariable") // JAXB reads the fields
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "runDrone",
        namespace = Namespace.URI,
        propOrder = {"droneId", "name", "stage", "note", "visited"})
public class SoapRunDrone {
    private String droneId = "";
    private String name = "";
    private String stage = "";
    private @Nullable String note;
    private int visited;

    static SoapRunDrone of(RunView.DroneView view) {
        SoapRunDrone drone = new SoapRunDrone();
        drone.droneId = view.id();
        drone.name = view.name();
        drone.stage = view.stage();
        drone.note = view.note();
        drone.visited = view.visited();
        return drone;
    }

    public String getDroneId() {
        return droneId;
    }

    public String getStage() {
        return stage;
    }
}
