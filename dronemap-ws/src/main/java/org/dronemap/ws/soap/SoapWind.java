package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import org.dronemap.ws.service.PlanRequest;
import org.jspecify.annotations.Nullable;

/** Wind that is the same everywhere: m/s, and the degrees that it comes from. */
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "wind",
        namespace = Namespace.URI,
        propOrder = {"speed", "from"})
public class SoapWind {
    private @Nullable Double speed;
    private @Nullable Double from;

    PlanRequest.WindRequest request() {
        return new PlanRequest.WindRequest(speed, from);
    }
}
