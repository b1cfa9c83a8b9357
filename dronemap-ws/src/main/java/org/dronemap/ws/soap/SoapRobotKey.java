package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import org.dronemap.ws.service.RobotKeyService.RobotKeyView;
import org.jspecify.annotations.Nullable;

/** The key of a robot: {@code robotKeyId} is the drone that the robot is; {@code key} stands only in the answer that made it. */
@SuppressWarnings("UnusedVariable") // JAXB reads the fields
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "robotKey",
        namespace = Namespace.URI,
        propOrder = {"robotKeyId", "label", "systemId", "owner", "madeBy", "madeAt", "connected", "key"})
public class SoapRobotKey {
    private String robotKeyId = "";
    private String label = "";
    private int systemId;
    private @Nullable String owner;
    private String madeBy = "";
    private String madeAt = "";
    private boolean connected;
    private @Nullable String key;

    static SoapRobotKey of(RobotKeyView view) {
        SoapRobotKey soap = new SoapRobotKey();
        soap.robotKeyId = view.id();
        soap.label = view.label();
        soap.systemId = view.systemId();
        soap.owner = view.owner();
        soap.madeBy = view.madeBy();
        soap.madeAt = view.madeAt().toString();
        soap.connected = view.connected();
        soap.key = view.key();
        return soap;
    }

    public String getRobotKeyId() {
        return robotKeyId;
    }

    public String getLabel() {
        return label;
    }

    public int getSystemId() {
        return systemId;
    }

    public @Nullable String getOwner() {
        return owner;
    }

    public @Nullable String getKey() {
        return key;
    }
}
