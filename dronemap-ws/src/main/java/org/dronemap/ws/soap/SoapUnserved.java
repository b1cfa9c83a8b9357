package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import org.dronemap.ws.service.PlanView;

/** A waypoint that nobody visits, and why. */
@SuppressWarnings("UnusedVariable") // JAXB reads the fields
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "unserved",
        namespace = Namespace.URI,
        propOrder = {"waypoint", "why"})
public class SoapUnserved {
    private String waypoint = "";
    private String why = "";

    static SoapUnserved of(PlanView.UnservedView view) {
        SoapUnserved unserved = new SoapUnserved();
        unserved.waypoint = view.waypoint();
        unserved.why = view.why();
        return unserved;
    }

    public String getWhy() {
        return why;
    }
}
