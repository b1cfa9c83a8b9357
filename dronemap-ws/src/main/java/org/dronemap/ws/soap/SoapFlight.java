package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.ws.service.FlightView;
import org.jspecify.annotations.Nullable;

/** A flight; {@code end} is missing while it goes on, and what is not known is missing, too. Units as in REST. */
@SuppressWarnings("UnusedVariable") // JAXB reads the fields
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "flight",
        namespace = Namespace.URI,
        propOrder = {
            "flightId",
            "droneId",
            "droneName",
            "start",
            "end",
            "state",
            "seconds",
            "distance",
            "highest",
            "fastest",
            "farthest",
            "batteryUsed",
            "user",
            "operation",
            "notice",
            "notes",
            "recordingId"
        })
public class SoapFlight {
    private String flightId = "";
    private String droneId = "";
    private String droneName = "";
    private String start = "";
    private @Nullable String end;
    private String state = "";
    private double seconds;
    private double distance;
    private @Nullable Double highest;
    private @Nullable Double fastest;
    private @Nullable Double farthest;
    private @Nullable Integer batteryUsed;
    private List<String> user = new ArrayList<>();
    private @Nullable String operation;
    private @Nullable String notice;
    private String notes = "";
    private List<String> recordingId = new ArrayList<>();

    static SoapFlight of(FlightView view) {
        SoapFlight soap = new SoapFlight();
        soap.flightId = view.id();
        soap.droneId = view.drone();
        soap.droneName = view.droneName();
        soap.start = view.start().toString();
        Instant ended = view.end();
        soap.end = ended == null ? null : ended.toString();
        soap.state = view.state();
        soap.seconds = view.seconds();
        soap.measured(view);
        soap.user.addAll(view.users());
        soap.operation = view.operation();
        soap.notice = view.notice();
        soap.notes = view.notes();
        soap.recordingId.addAll(view.recordings());
        return soap;
    }

    private void measured(FlightView view) {
        distance = view.distance();
        highest = view.highest();
        fastest = view.fastest();
        farthest = view.farthest();
        batteryUsed = view.battery().used();
    }

    public String getFlightId() {
        return flightId;
    }

    public String getDroneId() {
        return droneId;
    }

    public String getState() {
        return state;
    }

    public double getDistance() {
        return distance;
    }

    public @Nullable Integer getBatteryUsed() {
        return batteryUsed;
    }

    public List<String> getUser() {
        return List.copyOf(user);
    }
}
