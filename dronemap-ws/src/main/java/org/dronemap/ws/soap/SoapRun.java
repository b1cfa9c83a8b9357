package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.ws.service.RunView;
import org.jspecify.annotations.Nullable;

/** A mission run as it stands; {@code state}: running, paused, stopping or over. */
@SuppressWarnings("UnusedVariable") // JAXB reads the fields
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "run",
        namespace = Namespace.URI,
        propOrder = {"runId", "name", "state", "end", "proposal", "drone", "waypoint", "explanation"})
public class SoapRun {
    private String runId = "";
    private String name = "";
    private String state = "";
    private @Nullable String end;
    private @Nullable Integer proposal;
    private List<SoapRunDrone> drone = new ArrayList<>();
    private List<SoapRunWaypoint> waypoint = new ArrayList<>();
    private List<String> explanation = new ArrayList<>();

    static SoapRun of(RunView view) {
        SoapRun run = new SoapRun();
        run.runId = view.id();
        run.name = view.name();
        run.state = view.state();
        run.end = view.end();
        RunView.ProposalView waiting = view.proposal();
        run.proposal = waiting == null ? null : waiting.number();
        view.drones().forEach(one -> run.drone.add(SoapRunDrone.of(one)));
        view.waypoints().forEach(one -> run.waypoint.add(SoapRunWaypoint.of(one)));
        view.explanations().forEach(one -> run.explanation.add(one.words()));
        return run;
    }

    public String getRunId() {
        return runId;
    }

    public String getState() {
        return state;
    }

    public List<SoapRunDrone> getDrone() {
        return List.copyOf(drone);
    }

    public List<SoapRunWaypoint> getWaypoint() {
        return List.copyOf(waypoint);
    }
}
