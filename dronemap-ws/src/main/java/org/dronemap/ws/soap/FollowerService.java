package org.dronemap.ws.soap;

import static org.dronemap.ws.soap.Answering.answer;

import jakarta.jws.WebService;
import java.util.List;
import org.dronemap.core.access.Principal;
import org.dronemap.ws.service.FollowRequest;
import org.dronemap.ws.service.FollowService;
import org.jspecify.annotations.Nullable;

/** Following over SOAP. Any thread. */
@WebService(
        serviceName = "FollowerService",
        portName = "FollowerPort",
        endpointInterface = "org.dronemap.ws.soap.Follower",
        targetNamespace = Namespace.URI)
public class FollowerService implements Follower {
    private final SoapCaller caller;
    private final FollowService follows;

    public FollowerService(SoapCaller caller, FollowService follows) {
        this.caller = caller;
        this.follows = follows;
    }

    @Override
    public SoapFollow followRequest(
            @Nullable String droneId,
            @Nullable Double latitude,
            @Nullable Double longitude,
            @Nullable SoapPlace place,
            @Nullable Double minutes,
            @Nullable String name)
            throws DronemapFault {
        return answer(() -> SoapFollow.of(follows.open(
                caller.reading(),
                new FollowRequest.OpenRequest(
                        latitude,
                        longitude,
                        name,
                        droneId,
                        place == null ? null : place.request(),
                        minutes,
                        null,
                        null))));
    }

    @Override
    public SoapFollow cancelFollowRequest(String followId) throws DronemapFault {
        return answer(() -> SoapFollow.of(follows.cancel(caller.principal(), followId)));
    }

    @Override
    public SoapFollow startTracking(String followId) throws DronemapFault {
        return answer(() -> SoapFollow.of(follows.start(caller.principal(), followId)));
    }

    @Override
    public SoapFollow sendNewGPSLocation(
            String followId,
            @Nullable Double latitude,
            @Nullable Double longitude,
            @Nullable Double accuracy,
            @Nullable Double speed,
            @Nullable Double course)
            throws DronemapFault {
        return answer(() -> {
            Principal principal = caller.reading();
            follows.isAt(
                    principal,
                    followId,
                    new FollowRequest.PositionRequest(null, null, latitude, longitude, accuracy, speed, course));
            return SoapFollow.of(follows.one(principal, followId));
        });
    }

    @Override
    public SoapFollow disableTracking(String followId) throws DronemapFault {
        return answer(() -> SoapFollow.of(follows.pause(caller.principal(), followId)));
    }

    @Override
    public SoapFollow enableTracking(String followId) throws DronemapFault {
        return answer(() -> SoapFollow.of(follows.goOn(caller.principal(), followId)));
    }

    @Override
    public SoapFollow stopTracking(String followId) throws DronemapFault {
        return answer(() -> SoapFollow.of(follows.stop(caller.principal(), followId)));
    }

    @Override
    public List<SoapFollow> getFollowsList() throws DronemapFault {
        return answer(
                () -> follows.all(caller.reading()).stream().map(SoapFollow::of).toList());
    }

    @Override
    public SoapFollow getFollow(String followId) throws DronemapFault {
        return answer(() -> SoapFollow.of(follows.one(caller.reading(), followId)));
    }
}
