package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import org.dronemap.ws.service.FollowRequest;
import org.jspecify.annotations.Nullable;

/** Where a drone stays beside who is followed; metres and degrees. */
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "place",
        namespace = Namespace.URI,
        propOrder = {"side", "bearing", "turn", "distance", "height"})
public class SoapPlace {
    private @Nullable String side;
    private @Nullable Double bearing;
    private @Nullable Double turn;
    private @Nullable Double distance;
    private @Nullable Double height;

    FollowRequest.PlaceRequest request() {
        return new FollowRequest.PlaceRequest(side, bearing, turn, distance, height);
    }

    public void setDistance(Double meters) {
        distance = meters;
    }
}
