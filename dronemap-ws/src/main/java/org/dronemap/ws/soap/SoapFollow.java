package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.ws.service.FollowView;
import org.jspecify.annotations.Nullable;

/**
 * Somebody who is followed; {@code state}: allocated, starting, tracking, paused, suspended, returning or over. Degrees, metres
 * above the drone's home, metres from drone to phone, per cent, seconds until the drone has to fly home; {@code reliefId} and
 * {@code reliefName}: of a drone that is on its way to replace it.
 */
@SuppressWarnings("UnusedVariable") // JAXB reads the fields
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "follow",
        namespace = Namespace.URI,
        propOrder = {
            "followId",
            "name",
            "state",
            "note",
            "end",
            "droneId",
            "droneName",
            "reliefId",
            "reliefName",
            "latitude",
            "longitude",
            "height",
            "distance",
            "battery",
            "secondsLeft",
            "explanation"
        })
public class SoapFollow {
    private String followId = "";
    private String name = "";
    private String state = "";
    private @Nullable String note;
    private @Nullable String end;
    private String droneId = "";
    private String droneName = "";
    private @Nullable String reliefId;
    private @Nullable String reliefName;
    private @Nullable Double latitude;
    private @Nullable Double longitude;
    private @Nullable Double height;
    private @Nullable Double distance;
    private @Nullable Integer battery;
    private @Nullable Integer secondsLeft;
    private List<String> explanation = new ArrayList<>();

    static SoapFollow of(FollowView view) {
        SoapFollow follow = new SoapFollow();
        follow.followId = view.id();
        follow.name = view.name();
        follow.state = view.state();
        follow.note = view.note();
        follow.end = view.end();
        follow.droneId = view.drone();
        follow.droneName = view.droneName();
        view.others().stream().filter(FollowView.OtherView::comes).findFirst().ifPresent(other -> {
            follow.reliefId = other.drone();
            follow.reliefName = other.droneName();
        });
        view.told().forEach(one -> follow.explanation.add(one.words()));
        FollowView.NowView now = view.now();
        if (now != null) {
            follow.tell(now);
        }
        return follow;
    }

    private void tell(FollowView.NowView now) {
        FollowView.PointView at = now.droneAt();
        latitude = at == null ? null : at.latitude();
        longitude = at == null ? null : at.longitude();
        height = now.height();
        distance = now.distance();
        battery = now.battery();
        secondsLeft = now.secondsLeft();
    }

    public String getFollowId() {
        return followId;
    }

    public String getState() {
        return state;
    }

    public String getDroneId() {
        return droneId;
    }

    public @Nullable String getReliefName() {
        return reliefName;
    }

    public @Nullable Double getDistance() {
        return distance;
    }
}
