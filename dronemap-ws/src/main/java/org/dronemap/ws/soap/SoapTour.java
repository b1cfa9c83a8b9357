package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.ws.service.PlanView;
import org.jspecify.annotations.Nullable;

/** What one drone flies in a plan, and what became of it once the plan was accepted. */
@SuppressWarnings("UnusedVariable") // JAXB reads the fields
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "tour",
        namespace = Namespace.URI,
        propOrder = {
            "droneId",
            "departsSeconds",
            "endsSeconds",
            "distance",
            "wattHours",
            "batteryShare",
            "stop",
            "stage",
            "why",
            "commandId"
        })
public class SoapTour {
    private String droneId = "";
    private double departsSeconds;
    private double endsSeconds;
    private double distance;
    private double wattHours;
    private @Nullable Double batteryShare;
    private List<SoapStop> stop = new ArrayList<>();
    private @Nullable String stage;
    private @Nullable String why;
    private @Nullable String commandId;

    static SoapTour of(PlanView.TourView view, PlanView.@Nullable FlightView flight) {
        SoapTour tour = new SoapTour();
        tour.droneId = view.drone();
        tour.departsSeconds = view.departsSeconds();
        tour.endsSeconds = view.endsSeconds();
        tour.distance = view.distance();
        tour.wattHours = view.wattHours();
        tour.batteryShare = view.batteryShare();
        view.stops().forEach(stop -> tour.stop.add(SoapStop.of(stop)));
        if (flight != null) {
            tour.stage = flight.stage();
            tour.why = flight.why();
            tour.commandId = flight.command();
        }
        return tour;
    }

    public String getDroneId() {
        return droneId;
    }

    public List<SoapStop> getStop() {
        return List.copyOf(stop);
    }

    public @Nullable String getStage() {
        return stage;
    }
}
