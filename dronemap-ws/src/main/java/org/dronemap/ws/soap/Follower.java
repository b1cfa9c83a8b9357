package org.dronemap.ws.soap;

import jakarta.jws.WebMethod;
import jakarta.jws.WebParam;
import jakarta.jws.WebResult;
import jakarta.jws.WebService;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** The operations of the SOAP service by which somebody with a phone is followed, in the order in which they are called. */
@WebService(name = "Follower", targetNamespace = Namespace.URI)
public interface Follower {
    String FOLLOW = "follow";
    String FOLLOW_ID = "followId";

    /** A drone is allocated: the one that is named, or the best one of the warehouse. */
    @WebMethod
    @WebResult(name = FOLLOW)
    SoapFollow followRequest(
            @WebParam(name = "droneId") @Nullable String droneId,
            @WebParam(name = "latitude") @Nullable Double latitude,
            @WebParam(name = "longitude") @Nullable Double longitude,
            @WebParam(name = "place") @Nullable SoapPlace place,
            @WebParam(name = "minutes") @Nullable Double minutes,
            @WebParam(name = "name") @Nullable String name)
            throws DronemapFault;

    /** Before the drone follows. */
    @WebMethod
    @WebResult(name = FOLLOW)
    SoapFollow cancelFollowRequest(@WebParam(name = FOLLOW_ID) String followId) throws DronemapFault;

    /** The drone takes off and comes. */
    @WebMethod
    @WebResult(name = FOLLOW)
    SoapFollow startTracking(@WebParam(name = FOLLOW_ID) String followId) throws DronemapFault;

    /** Where the phone is now; with speed in m/s and course in degrees, where it has them. */
    @WebMethod
    @WebResult(name = FOLLOW)
    SoapFollow sendNewGPSLocation(
            @WebParam(name = FOLLOW_ID) String followId,
            @WebParam(name = "latitude") @Nullable Double latitude,
            @WebParam(name = "longitude") @Nullable Double longitude,
            @WebParam(name = "accuracy") @Nullable Double accuracy,
            @WebParam(name = "speed") @Nullable Double speed,
            @WebParam(name = "course") @Nullable Double course)
            throws DronemapFault;

    /** The drone stays where it is. */
    @WebMethod
    @WebResult(name = FOLLOW)
    SoapFollow disableTracking(@WebParam(name = FOLLOW_ID) String followId) throws DronemapFault;

    /** The drone follows again. */
    @WebMethod
    @WebResult(name = FOLLOW)
    SoapFollow enableTracking(@WebParam(name = FOLLOW_ID) String followId) throws DronemapFault;

    /** The drone flies home. */
    @WebMethod
    @WebResult(name = FOLLOW)
    SoapFollow stopTracking(@WebParam(name = FOLLOW_ID) String followId) throws DronemapFault;

    @WebMethod
    @WebResult(name = FOLLOW)
    List<SoapFollow> getFollowsList() throws DronemapFault;

    @WebMethod
    @WebResult(name = FOLLOW)
    SoapFollow getFollow(@WebParam(name = FOLLOW_ID) String followId) throws DronemapFault;
}
