package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.ws.service.PlanRequest;
import org.jspecify.annotations.Nullable;

/** A place that one of several drones is to visit; degrees, metres, seconds, as in REST. */
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "visit",
        namespace = Namespace.URI,
        propOrder = {
            "id",
            "latitude",
            "longitude",
            "altitude",
            "altitudeReference",
            "holdSeconds",
            "priority",
            "opensSeconds",
            "closesSeconds",
            "need",
            "task"
        })
public class SoapVisit {
    private @Nullable String id;
    private @Nullable Double latitude;
    private @Nullable Double longitude;
    private @Nullable Double altitude;
    private @Nullable String altitudeReference;
    private @Nullable Double holdSeconds;
    private @Nullable Double priority;
    private @Nullable Double opensSeconds;
    private @Nullable Double closesSeconds;
    private List<String> need = new ArrayList<>();
    private List<SoapTask> task = new ArrayList<>();

    PlanRequest.WaypointRequest request() {
        return new PlanRequest.WaypointRequest(
                id,
                latitude,
                longitude,
                altitude,
                altitudeReference,
                holdSeconds,
                priority,
                opensSeconds == null && closesSeconds == null
                        ? null
                        : new PlanRequest.WindowRequest(opensSeconds, closesSeconds),
                need.isEmpty() ? null : List.copyOf(need),
                task.isEmpty() ? null : task.stream().map(SoapTask::request).toList());
    }

    /** For callers in Java. */
    public static SoapVisit at(
            @Nullable Double latitude, @Nullable Double longitude, @Nullable Double altitudeAboveHome) {
        SoapVisit visit = new SoapVisit();
        visit.latitude = latitude;
        visit.longitude = longitude;
        visit.altitude = altitudeAboveHome;
        return visit;
    }
}
