package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlType;
import org.dronemap.ws.service.ParametersView;

/** A parameter of a vehicle; {@code type} as in REST: int8 to int64, uint8 to uint64, real32 or real64. */
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "parameter",
        namespace = Namespace.URI,
        propOrder = {"name", "type", "value"})
public class SoapParameter {
    @XmlElement(required = true)
    private String name = "";

    @XmlElement(required = true)
    private String type = "";

    private double value;

    static SoapParameter of(ParametersView.ParameterView view) {
        SoapParameter soap = new SoapParameter();
        soap.name = view.name();
        soap.type = view.type();
        soap.value = view.value();
        return soap;
    }

    public String getName() {
        return name;
    }

    public String getType() {
        return type;
    }

    public double getValue() {
        return value;
    }
}
