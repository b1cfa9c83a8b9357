package org.dronemap.ws.soap;

import jakarta.jws.WebMethod;
import jakarta.jws.WebParam;
import jakarta.jws.WebResult;
import jakarta.jws.WebService;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** The operations of the SOAP service; every action waits up to 30 s for its outcome. */
@WebService(name = "MAVLinkController", targetNamespace = Namespace.URI)
public interface MAVLinkController {
    String DRONE = "droneId";
    String OUTCOME = "commandOutcome";
    String CONTROL = "control";
    String PLAN = "plan";
    String PLAN_ID = "planId";
    String RUN = "run";
    String RUN_ID = "runId";
    String VIRTUAL = "virtualDrone";
    String VIRTUAL_ID = "virtualDroneId";
    String FLIGHT = "flight";
    String ROBOT_KEY = "robotKey";
    String ROBOT_KEY_ID = "robotKeyId";

    @WebMethod
    @WebResult(name = "drone")
    List<SoapDrone> getDronesList() throws DronemapFault;

    @WebMethod
    @WebResult(name = "drone")
    SoapDrone getDrone(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome arm(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    /** {@code force} stops the motors even in the air. */
    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome disarm(@WebParam(name = DRONE) String droneId, @WebParam(name = "force") @Nullable Boolean force)
            throws DronemapFault;

    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome setMode(@WebParam(name = DRONE) String droneId, @WebParam(name = "mode") @Nullable String mode)
            throws DronemapFault;

    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome takeoff(@WebParam(name = DRONE) String droneId, @WebParam(name = "altitude") @Nullable Double altitude)
            throws DronemapFault;

    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome land(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome returnToLaunch(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome hold(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    /** The altitude is above home. */
    @WebMethod(operationName = "goto")
    @WebResult(name = OUTCOME)
    SoapOutcome goTo(
            @WebParam(name = DRONE) String droneId,
            @WebParam(name = "latitude") @Nullable Double latitude,
            @WebParam(name = "longitude") @Nullable Double longitude,
            @WebParam(name = "altitude") @Nullable Double altitude)
            throws DronemapFault;

    /** A place on the vehicle's own map, in metres. */
    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome goToLocal(
            @WebParam(name = DRONE) String droneId,
            @WebParam(name = "x") @Nullable Double x,
            @WebParam(name = "y") @Nullable Double y)
            throws DronemapFault;

    /** It gives up its way as well; hold stops it alone. */
    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome emergencyStop(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    /** REST then has its map. */
    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome readMap(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome uploadMission(
            @WebParam(name = DRONE) String droneId, @WebParam(name = "waypoint") @Nullable List<SoapWaypoint> waypoints)
            throws DronemapFault;

    /** The mission that was read back from the vehicle. */
    @WebMethod
    @WebResult(name = "waypoint")
    List<SoapWaypoint> downloadMission(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome startMission(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome pauseMission(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome clearMission(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    /** Degrees from where it looks now, clockwise when positive. */
    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome turn(@WebParam(name = DRONE) String droneId, @WebParam(name = "degrees") @Nullable Double degrees)
            throws DronemapFault;

    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome takePicture(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    /** {@code setting}: off, on or toggle. */
    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome setRelay(
            @WebParam(name = DRONE) String droneId,
            @WebParam(name = "relay") @Nullable Integer relay,
            @WebParam(name = "setting") @Nullable String setting)
            throws DronemapFault;

    /** The altitude is above sea level; without a place: where the vehicle is. */
    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome setHome(
            @WebParam(name = DRONE) String droneId,
            @WebParam(name = "latitude") @Nullable Double latitude,
            @WebParam(name = "longitude") @Nullable Double longitude,
            @WebParam(name = "altitudeAmsl") @Nullable Double altitudeAmsl)
            throws DronemapFault;

    /** Asks the vehicle for all its parameters. */
    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome readParameters(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    /** As last heard; those whose name has all the words of {@code search} in it, all without. */
    @WebMethod
    @WebResult(name = "parameter")
    List<SoapParameter> getParameters(
            @WebParam(name = DRONE) String droneId, @WebParam(name = "search") @Nullable String search)
            throws DronemapFault;

    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome setParameter(
            @WebParam(name = DRONE) String droneId,
            @WebParam(name = "name") @Nullable String name,
            @WebParam(name = "value") @Nullable Double value)
            throws DronemapFault;

    /** Who has control. */
    @WebMethod
    @WebResult(name = CONTROL)
    SoapControl getControl(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    /** Where nobody has it; kept by a heartbeat every 2 s. */
    @WebMethod
    @WebResult(name = CONTROL)
    SoapControl takeControl(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    /** From whoever has it; for supervisors. */
    @WebMethod
    @WebResult(name = CONTROL)
    SoapControl takeOverControl(
            @WebParam(name = DRONE) String droneId, @WebParam(name = "reason") @Nullable String reason)
            throws DronemapFault;

    /** To a user by name. */
    @WebMethod
    @WebResult(name = CONTROL)
    SoapControl handControlOver(@WebParam(name = DRONE) String droneId, @WebParam(name = "user") @Nullable String user)
            throws DronemapFault;

    @WebMethod
    @WebResult(name = CONTROL)
    SoapControl controlHeartbeat(@WebParam(name = DRONE) String droneId, @WebParam(name = "epoch") @Nullable Long epoch)
            throws DronemapFault;

    @WebMethod
    @WebResult(name = CONTROL)
    SoapControl giveControlBack(@WebParam(name = DRONE) String droneId) throws DronemapFault;

    /** Shares the visits out among the drones, in the background: ask for it by getPlan until it is finished. */
    @WebMethod
    @WebResult(name = PLAN)
    SoapPlan planMission(
            @WebParam(name = DRONE) @Nullable List<String> droneIds,
            @WebParam(name = "visit") @Nullable List<SoapVisit> visits,
            @WebParam(name = "objective") @Nullable SoapObjective objective,
            @WebParam(name = "wind") @Nullable SoapWind wind,
            @WebParam(name = "seconds") @Nullable Double seconds)
            throws DronemapFault;

    @WebMethod
    @WebResult(name = PLAN)
    SoapPlan getPlan(@WebParam(name = PLAN_ID) String planId) throws DronemapFault;

    /** Uploads each drone's mission and, with {@code start}, starts the drones; {@code underWay}: not all is done yet. */
    @WebMethod
    @WebResult(name = PLAN)
    SoapPlan acceptPlan(
            @WebParam(name = PLAN_ID) String planId,
            @WebParam(name = "start") @Nullable Boolean start,
            @WebParam(name = "onCloudLoss") @Nullable String onCloudLoss)
            throws DronemapFault;

    /** Nobody else of an accepted plan is started. */
    @WebMethod
    @WebResult(name = PLAN)
    SoapPlan stopPlan(@WebParam(name = PLAN_ID) String planId) throws DronemapFault;

    /** Cancels one that is searched for; forgets one that has ended. */
    @WebMethod
    void cancelPlan(@WebParam(name = PLAN_ID) String planId) throws DronemapFault;

    /** Has the cloud fly a finished plan; {@code mode}: automatic or askFirst, {@code onCloudLoss}: continue or rtl. */
    @WebMethod
    @WebResult(name = RUN)
    SoapRun startRun(
            @WebParam(name = PLAN_ID) String planId,
            @WebParam(name = "mode") @Nullable String mode,
            @WebParam(name = "onCloudLoss") @Nullable String onCloudLoss,
            @WebParam(name = "name") @Nullable String name)
            throws DronemapFault;

    /** Under way, and the newest that are over, the newest first. */
    @WebMethod
    @WebResult(name = RUN)
    List<SoapRun> getRunsList() throws DronemapFault;

    @WebMethod
    @WebResult(name = RUN)
    SoapRun getRun(@WebParam(name = RUN_ID) String runId) throws DronemapFault;

    @WebMethod
    @WebResult(name = RUN)
    SoapRun addRunWaypoint(
            @WebParam(name = RUN_ID) String runId, @WebParam(name = "visit") @Nullable List<SoapVisit> visits)
            throws DronemapFault;

    /** Gives a drone back that a pilot or somebody else took. */
    @WebMethod
    @WebResult(name = RUN)
    SoapRun resumeRunDrone(@WebParam(name = RUN_ID) String runId, @WebParam(name = DRONE) @Nullable String droneId)
            throws DronemapFault;

    /** Whether what a run proposes is to be flown. */
    @WebMethod
    @WebResult(name = RUN)
    SoapRun answerRun(
            @WebParam(name = RUN_ID) String runId,
            @WebParam(name = "proposal") @Nullable Integer proposal,
            @WebParam(name = "accept") @Nullable Boolean accept)
            throws DronemapFault;

    /** Its drones wait where they are. */
    @WebMethod
    @WebResult(name = RUN)
    SoapRun pauseRun(@WebParam(name = RUN_ID) String runId) throws DronemapFault;

    /** All go on where they stopped. */
    @WebMethod
    @WebResult(name = RUN)
    SoapRun continueRun(@WebParam(name = RUN_ID) String runId) throws DronemapFault;

    /** All of its drones come home. */
    @WebMethod
    @WebResult(name = RUN)
    SoapRun stopRun(@WebParam(name = RUN_ID) String runId) throws DronemapFault;

    /** One's own; of all of the organisation for its supervisors. */
    @WebMethod
    @WebResult(name = VIRTUAL)
    List<SoapVirtualDrone> getVirtualDronesList() throws DronemapFault;

    @WebMethod
    @WebResult(name = VIRTUAL)
    SoapVirtualDrone getVirtualDrone(@WebParam(name = VIRTUAL_ID) String virtualDroneId) throws DronemapFault;

    /** Kind, endurance and needs (names of actions) say what a drone must be to serve. */
    @WebMethod
    @WebResult(name = VIRTUAL)
    SoapVirtualDrone createVirtualDrone(
            @WebParam(name = "name") @Nullable String name,
            @WebParam(name = "kind") @Nullable String kind,
            @WebParam(name = "enduranceMinutes") @Nullable Integer enduranceMinutes,
            @WebParam(name = "need") @Nullable List<String> needs,
            @WebParam(name = "waypoint") @Nullable List<SoapWaypoint> waypoints)
            throws DronemapFault;

    /** Asks for a drone to fly its mission: ask for it by getVirtualDrone until it is done. */
    @WebMethod
    @WebResult(name = VIRTUAL)
    SoapVirtualDrone startVirtualDrone(
            @WebParam(name = VIRTUAL_ID) String virtualDroneId,
            @WebParam(name = "onCloudLoss") @Nullable String onCloudLoss)
            throws DronemapFault;

    /** Calls the drone home that serves it. */
    @WebMethod
    @WebResult(name = VIRTUAL)
    SoapVirtualDrone stopVirtualDrone(@WebParam(name = VIRTUAL_ID) String virtualDroneId) throws DronemapFault;

    @WebMethod
    @WebResult(name = VIRTUAL)
    SoapVirtualDrone resumeVirtualDrone(@WebParam(name = VIRTUAL_ID) String virtualDroneId) throws DronemapFault;

    @WebMethod
    void removeVirtualDrone(@WebParam(name = VIRTUAL_ID) String virtualDroneId) throws DronemapFault;

    /** Newest first, 50 at most; {@code before}: the id of the last flight of the answer before. Times as in REST. */
    @WebMethod
    @WebResult(name = FLIGHT)
    List<SoapFlight> getFlightsList(
            @WebParam(name = DRONE) @Nullable String droneId,
            @WebParam(name = "user") @Nullable String user,
            @WebParam(name = "from") @Nullable String from,
            @WebParam(name = "until") @Nullable String until,
            @WebParam(name = "words") @Nullable String words,
            @WebParam(name = "before") @Nullable String before)
            throws DronemapFault;

    @WebMethod
    @WebResult(name = FLIGHT)
    SoapFlight getFlight(@WebParam(name = "flightId") String flightId) throws DronemapFault;

    @WebMethod
    @WebResult(name = OUTCOME)
    SoapOutcome getCommand(@WebParam(name = "commandId") String commandId) throws DronemapFault;

    @WebMethod
    @WebResult(name = ROBOT_KEY)
    List<SoapRobotKey> getRobotKeysList() throws DronemapFault;

    /** With {@code robotKeyId} it replaces that one, which is void at once; the key is in this answer only. */
    @WebMethod
    @WebResult(name = ROBOT_KEY)
    SoapRobotKey issueRobotKey(
            @WebParam(name = ROBOT_KEY_ID) @Nullable String robotKeyId,
            @WebParam(name = "label") @Nullable String label,
            @WebParam(name = "systemId") @Nullable Integer systemId,
            @WebParam(name = "owner") @Nullable String owner,
            @WebParam(name = "organisation") @Nullable String organisation)
            throws DronemapFault;

    @WebMethod
    void revokeRobotKey(@WebParam(name = ROBOT_KEY_ID) String robotKeyId) throws DronemapFault;
}
