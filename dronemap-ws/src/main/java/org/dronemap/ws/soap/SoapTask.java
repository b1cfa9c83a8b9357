package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import org.dronemap.ws.service.InvalidInput;
import org.dronemap.ws.service.PlanTaskRequest;
import org.jspecify.annotations.Nullable;

/** Something that is done at a waypoint; {@code type} and what belongs to it as in REST. */
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "task",
        namespace = Namespace.URI,
        propOrder = {"type", "output", "pulse", "latitude", "longitude", "altitude", "seconds"})
public class SoapTask {
    private @Nullable String type;
    private @Nullable Integer output;
    private @Nullable Integer pulse;
    private @Nullable Double latitude;
    private @Nullable Double longitude;
    private @Nullable Double altitude;
    private @Nullable Double seconds;

    @Nullable
    PlanTaskRequest request() {
        return switch (type == null ? "" : type) {
            case "" -> null;
            case "photo" -> new PlanTaskRequest.Photo();
            case "servo" -> new PlanTaskRequest.Servo(output, pulse);
            case "lookAt" -> new PlanTaskRequest.LookAt(latitude, longitude, altitude);
            case "readSensors" -> new PlanTaskRequest.ReadSensors(seconds);
            default ->
                throw InvalidInput.outside("tasks.type", "photo, servo, lookAt or readSensors", "\"" + type + "\"");
        };
    }
}
