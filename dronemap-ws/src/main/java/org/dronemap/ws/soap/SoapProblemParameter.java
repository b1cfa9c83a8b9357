package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.XmlType;
import jakarta.xml.bind.annotation.XmlValue;

/** What a fault is about, such as the drone: a name and a value, {@code type} says of which type of JSON it is elsewhere. */
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(name = "problemParameter", namespace = Namespace.URI)
public class SoapProblemParameter {
    @XmlAttribute(required = true)
    private String name = "";

    @XmlAttribute(required = true)
    private String type = "";

    @XmlValue
    private String value = "";

    static SoapProblemParameter of(String name, Object value) {
        SoapProblemParameter parameter = new SoapProblemParameter();
        parameter.name = name;
        parameter.type = value instanceof Number ? "number" : "string";
        parameter.value = String.valueOf(value);
        return parameter;
    }

    public String getName() {
        return name;
    }

    public String getType() {
        return type;
    }

    public String getValue() {
        return value;
    }
}
