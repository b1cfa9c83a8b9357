package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlType;
import org.dronemap.ws.service.ControlView;
import org.jspecify.annotations.Nullable;

/** Who commands a drone; {@code state}: free, held or pilot. */
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "control",
        namespace = Namespace.URI,
        propOrder = {"state", "holder", "explicit", "since", "epoch"})
public class SoapControl {
    @XmlElement(required = true)
    private String state = "";

    private @Nullable String holder;
    private boolean explicit;
    private @Nullable String since;
    private long epoch;

    static SoapControl of(ControlView view) {
        SoapControl soap = new SoapControl();
        soap.state = view.state();
        soap.holder = view.holder();
        soap.explicit = view.explicit();
        soap.since = view.since() == null ? null : String.valueOf(view.since());
        soap.epoch = view.epoch();
        return soap;
    }

    public String getState() {
        return state;
    }

    public @Nullable String getHolder() {
        return holder;
    }

    public boolean isExplicit() {
        return explicit;
    }

    public @Nullable String getSince() {
        return since;
    }

    public long getEpoch() {
        return epoch;
    }
}
