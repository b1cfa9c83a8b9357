package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import org.dronemap.ws.service.PlanRequest;
import org.jspecify.annotations.Nullable;

/** What a plan is to be good at; members as in REST. */
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "objective",
        namespace = Namespace.URI,
        propOrder = {"kind", "longestWeight", "sumWeight", "measure", "everyDrone"})
public class SoapObjective {
    private @Nullable String kind;
    private @Nullable Double longestWeight;
    private @Nullable Double sumWeight;
    private @Nullable String measure;
    private @Nullable Boolean everyDrone;

    PlanRequest.ObjectiveRequest request() {
        return new PlanRequest.ObjectiveRequest(kind, longestWeight, sumWeight, measure, everyDrone);
    }
}
