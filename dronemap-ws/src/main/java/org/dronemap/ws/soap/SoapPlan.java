package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.ws.service.PlanView;
import org.jspecify.annotations.Nullable;

/** A plan for several drones, from being asked for to being flown; {@code state} as in REST. */
@SuppressWarnings("UnusedVariable") // JAXB reads the fields
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "plan",
        namespace = Namespace.URI,
        propOrder = {"planId", "state", "why", "endsSeconds", "gap", "underWay", "tour", "unserved", "fault"})
public class SoapPlan {
    private String planId = "";
    private String state = "";
    private @Nullable String why;
    private @Nullable Double endsSeconds;
    private @Nullable Double gap;
    private boolean underWay;
    private List<SoapTour> tour = new ArrayList<>();
    private List<SoapUnserved> unserved = new ArrayList<>();
    private List<String> fault = new ArrayList<>();

    static SoapPlan of(PlanView view) {
        SoapPlan plan = new SoapPlan();
        plan.planId = view.id();
        plan.state = view.state();
        plan.why = view.why();
        PlanView.ProgressView progress = view.progress();
        if (progress != null) {
            plan.endsSeconds = progress.longestSeconds();
            plan.gap = progress.gap();
        }
        PlanView.LaunchView launch = view.launch();
        plan.underWay = launch != null && launch.underWay();
        PlanView.ResultView result = view.result();
        if (result != null) {
            plan.endsSeconds = result.endsSeconds();
            plan.fill(result, launch);
        }
        return plan;
    }

    private void fill(PlanView.ResultView result, PlanView.@Nullable LaunchView launch) {
        result.tours().forEach(one -> tour.add(SoapTour.of(one, flight(launch, one.drone()))));
        result.unserved().forEach(one -> unserved.add(SoapUnserved.of(one)));
        fault.addAll(result.faults());
    }

    private static PlanView.@Nullable FlightView flight(PlanView.@Nullable LaunchView launch, String drone) {
        return launch == null
                ? null
                : launch.drones().stream()
                        .filter(one -> one.drone().equals(drone))
                        .findFirst()
                        .orElse(null);
    }

    public String getPlanId() {
        return planId;
    }

    public String getState() {
        return state;
    }

    public List<SoapTour> getTour() {
        return List.copyOf(tour);
    }

    public List<SoapUnserved> getUnserved() {
        return List.copyOf(unserved);
    }
}
