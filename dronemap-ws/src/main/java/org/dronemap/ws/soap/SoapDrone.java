package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlType;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.dronemap.ws.service.DroneView;
import org.dronemap.ws.service.OutlookView;
import org.jspecify.annotations.Nullable;

/** A drone now, flat; what nobody knows is left out. Degrees, metres, m/s, volts, UTC. */
@SuppressWarnings("UnusedVariable") // JAXB reads the fields
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(name = "drone", namespace = Namespace.URI)
public class SoapDrone {
    @XmlElement(required = true)
    private String id = "";

    @XmlElement(required = true)
    private String name = "";

    private boolean replay;
    private @Nullable String address;
    private int port;
    private int systemId;
    private @Nullable String transport;
    private @Nullable String linkState;
    private @Nullable String lastHeard;
    private @Nullable String kind;
    private @Nullable String autopilot;
    private @Nullable String vehicle;
    private @Nullable String firmware;
    private @Nullable String mode;
    private List<String> modes = new ArrayList<>();
    private @Nullable Boolean armed;
    private @Nullable String flight;
    private @Nullable Double latitude;
    private @Nullable Double longitude;
    private @Nullable Double altitudeAmsl;
    private @Nullable Double altitudeAboveHome;
    private @Nullable Double localX;
    private @Nullable Double localY;
    private @Nullable Double localZ;
    private @Nullable Double localYaw;
    private @Nullable String place;
    private @Nullable Double groundSpeed;
    private @Nullable Double airSpeed;
    private @Nullable Double climbRate;
    private @Nullable Double heading;
    private @Nullable Integer batteryPercent;
    private @Nullable Double batteryVolts;
    private @Nullable String gpsFix;
    private @Nullable Integer gpsSatellites;
    private @Nullable Integer missionCurrent;
    private @Nullable Integer missionTotal;
    private @Nullable String lastUpdate;
    private @Nullable String withoutCloud;
    private @Nullable String outlook;
    private @Nullable String then;
    private @Nullable String returnsAt;
    private @Nullable String comesDown;
    private @Nullable Double comesDownLatitude;
    private @Nullable Double comesDownLongitude;
    private @Nullable String emptyAt;

    static SoapDrone of(DroneView view) {
        SoapDrone drone = new SoapDrone();
        drone.id = view.id();
        drone.name = view.name();
        drone.replay = view.replay();
        drone.link(view.link());
        drone.kind = view.kind();
        drone.autopilot = view.autopilot();
        drone.vehicle = view.vehicle();
        drone.firmware = view.firmware();
        drone.mode = view.mode();
        drone.modes = view.modes();
        drone.armed = view.armed();
        drone.flight = view.flight();
        drone.place = view.place();
        drone.missionCurrent = view.mission().current();
        drone.missionTotal = view.mission().total();
        drone.lastUpdate = view.lastUpdate().toString();
        drone.withoutCloud = view.cloudLoss().sentence();
        drone.outlook(view.outlook());
        drone.where(view.position());
        drone.where(view.local());
        drone.motion(view.motion());
        drone.power(view);
        return drone;
    }

    private void link(DroneView.LinkView link) {
        address = link.address();
        port = link.port();
        systemId = link.systemId();
        transport = link.transport();
        linkState = link.state();
        lastHeard = link.lastHeard() == null ? null : Objects.toString(link.lastHeard());
    }

    private void where(DroneView.@Nullable PositionView position) {
        if (position != null) {
            latitude = position.latitude();
            longitude = position.longitude();
            altitudeAmsl = position.altitudeAmsl();
            altitudeAboveHome = position.altitudeAboveHome();
        }
    }

    private void where(DroneView.@Nullable LocalView local) {
        if (local != null) {
            localX = local.x();
            localY = local.y();
            localZ = local.z();
            localYaw = local.yaw();
        }
    }

    private void motion(DroneView.@Nullable MotionView motion) {
        if (motion != null) {
            groundSpeed = motion.groundSpeed();
            airSpeed = motion.airSpeed();
            climbRate = motion.climbRate();
            heading = motion.heading();
        }
    }

    private void outlook(@Nullable OutlookView outlook) {
        if (outlook != null) {
            this.outlook = outlook.state();
            then = outlook.then();
            returnsAt = outlook.returnsAt() == null ? null : Objects.toString(outlook.returnsAt());
            comesDown = outlook.comesDown();
            comesDownLatitude = outlook.latitude();
            comesDownLongitude = outlook.longitude();
            emptyAt = outlook.emptyAt() == null ? null : Objects.toString(outlook.emptyAt());
        }
    }

    private void power(DroneView view) {
        DroneView.BatteryView battery = view.battery();
        if (battery != null) {
            batteryPercent = battery.percent();
            batteryVolts = battery.volts();
        }
        DroneView.GpsView gps = view.gps();
        if (gps != null) {
            gpsFix = gps.fix();
            gpsSatellites = gps.satellites();
        }
    }

    public String getId() {
        return id;
    }

    public String getName() {
        return name;
    }

    public @Nullable String getMode() {
        return mode;
    }

    public @Nullable Boolean getArmed() {
        return armed;
    }

    public @Nullable Double getLatitude() {
        return latitude;
    }
}
