package org.dronemap.ws.soap;

import static org.dronemap.ws.soap.Answering.answer;

import jakarta.jws.WebService;
import java.util.List;
import org.dronemap.ws.service.CommandRequest;
import org.dronemap.ws.service.ControlAction;
import org.dronemap.ws.service.ControlRequestView;
import org.dronemap.ws.service.ControlService;
import org.dronemap.ws.service.DroneProblem;
import org.dronemap.ws.service.DroneService;
import org.dronemap.ws.service.FlightSearch;
import org.dronemap.ws.service.MissionItemView;
import org.dronemap.ws.service.ParameterService;
import org.dronemap.ws.service.ProblemParameter;
import org.dronemap.ws.service.Rejection;
import org.jspecify.annotations.Nullable;

/** The SOAP service over the use cases. Any thread; an action keeps its request's thread for up to 30 s. */
@WebService(
        serviceName = "MAVLinkControllerService",
        portName = "MAVLinkControllerWSImplPort",
        endpointInterface = "org.dronemap.ws.soap.MAVLinkController",
        targetNamespace = Namespace.URI)
public class ControllerService extends RobotKeyCalls {
    private final SoapCaller caller;
    private final DroneService drones;
    private final SoapActions actions;
    private final ControlService controls;
    private final ParameterService parameters;
    private final SoapPlans plans;
    private final SoapRuns runs;
    private final SoapVirtualDrones virtuals;
    private final SoapFlights flights;

    public ControllerService(
            SoapCaller caller,
            DroneService drones,
            SoapActions actions,
            ControlService controls,
            ParameterService parameters,
            SoapMissions missions) {
        super(missions.robotKeys());
        this.caller = caller;
        this.drones = drones;
        this.actions = actions;
        this.controls = controls;
        this.parameters = parameters;
        this.plans = missions.plans();
        this.runs = missions.runs();
        this.virtuals = missions.virtuals();
        this.flights = missions.flights();
    }

    @Override
    public List<SoapDrone> getDronesList() throws DronemapFault {
        return answer(() ->
                drones.drones(caller.reading()).stream().map(SoapDrone::of).toList());
    }

    @Override
    public SoapDrone getDrone(String droneId) throws DronemapFault {
        return answer(() -> SoapDrone.of(drones.drone(caller.reading(), droneId)));
    }

    @Override
    public SoapOutcome arm(String droneId) throws DronemapFault {
        return actions.act(droneId, CommandRequest.simple("arm"));
    }

    @Override
    public SoapOutcome disarm(String droneId, @Nullable Boolean force) throws DronemapFault {
        return actions.act(droneId, CommandRequest.disarm(force));
    }

    @Override
    public SoapOutcome setMode(String droneId, @Nullable String mode) throws DronemapFault {
        return actions.act(droneId, CommandRequest.setMode(mode));
    }

    @Override
    public SoapOutcome takeoff(String droneId, @Nullable Double altitude) throws DronemapFault {
        return actions.act(droneId, CommandRequest.takeOff(altitude));
    }

    @Override
    public SoapOutcome land(String droneId) throws DronemapFault {
        return actions.act(droneId, CommandRequest.simple("land"));
    }

    @Override
    public SoapOutcome returnToLaunch(String droneId) throws DronemapFault {
        return actions.act(droneId, CommandRequest.simple("returnToLaunch"));
    }

    @Override
    public SoapOutcome hold(String droneId) throws DronemapFault {
        return actions.act(droneId, CommandRequest.simple("hold"));
    }

    @Override
    public SoapOutcome goTo(
            String droneId, @Nullable Double latitude, @Nullable Double longitude, @Nullable Double altitude)
            throws DronemapFault {
        return actions.act(droneId, CommandRequest.goTo(latitude, longitude, altitude));
    }

    @Override
    public SoapOutcome goToLocal(String droneId, @Nullable Double x, @Nullable Double y) throws DronemapFault {
        return actions.act(droneId, CommandRequest.goToLocal(x, y));
    }

    @Override
    public SoapOutcome emergencyStop(String droneId) throws DronemapFault {
        return actions.act(droneId, CommandRequest.simple("emergencyStop"));
    }

    @Override
    public SoapOutcome readMap(String droneId) throws DronemapFault {
        return actions.act(droneId, CommandRequest.simple("readMap"));
    }

    @Override
    public SoapOutcome uploadMission(String droneId, @Nullable List<SoapWaypoint> waypoints) throws DronemapFault {
        List<MissionItemView> items = waypoints == null
                ? null
                : waypoints.stream().map(SoapWaypoint::view).toList();
        return actions.act(droneId, CommandRequest.uploadMission(items));
    }

    @Override
    public List<SoapWaypoint> downloadMission(String droneId) throws DronemapFault {
        return answer(() -> {
            List<MissionItemView> items =
                    drones.drone(caller.reading(), droneId).mission().items();
            if (items == null) {
                throw Rejection.of(
                        DroneProblem.MISSION_NOT_READ,
                        "The mission on the vehicle has not been read yet.",
                        ProblemParameter.DRONE.is(droneId));
            }
            return items.stream().map(SoapWaypoint::of).toList();
        });
    }

    @Override
    public SoapOutcome startMission(String droneId) throws DronemapFault {
        return actions.act(droneId, CommandRequest.simple("startMission"));
    }

    @Override
    public SoapOutcome pauseMission(String droneId) throws DronemapFault {
        return actions.act(droneId, CommandRequest.simple("pauseMission"));
    }

    @Override
    public SoapOutcome clearMission(String droneId) throws DronemapFault {
        return actions.act(droneId, CommandRequest.simple("clearMission"));
    }

    @Override
    public SoapOutcome turn(String droneId, @Nullable Double degrees) throws DronemapFault {
        return actions.act(droneId, CommandRequest.turn(degrees));
    }

    @Override
    public SoapOutcome takePicture(String droneId) throws DronemapFault {
        return actions.act(droneId, CommandRequest.simple("takePicture"));
    }

    @Override
    public SoapOutcome setRelay(String droneId, @Nullable Integer relay, @Nullable String setting)
            throws DronemapFault {
        return actions.act(droneId, CommandRequest.setRelay(relay, setting));
    }

    @Override
    public SoapOutcome setHome(
            String droneId, @Nullable Double latitude, @Nullable Double longitude, @Nullable Double altitudeAmsl)
            throws DronemapFault {
        return actions.act(droneId, CommandRequest.setHome(latitude, longitude, altitudeAmsl));
    }

    @Override
    public SoapOutcome readParameters(String droneId) throws DronemapFault {
        return actions.act(droneId, CommandRequest.simple("readParameters"));
    }

    @Override
    public List<SoapParameter> getParameters(String droneId, @Nullable String search) throws DronemapFault {
        return answer(() -> {
            return parameters.parameters(caller.reading(), droneId, search).parameters().stream()
                    .map(SoapParameter::of)
                    .toList();
        });
    }

    @Override
    public SoapOutcome setParameter(String droneId, @Nullable String name, @Nullable Double value)
            throws DronemapFault {
        return actions.act(droneId, CommandRequest.setParameter(name, value));
    }

    @Override
    public SoapControl getControl(String droneId) throws DronemapFault {
        return answer(() -> SoapControl.of(controls.control(caller.principal(), droneId)));
    }

    @Override
    public SoapControl takeControl(String droneId) throws DronemapFault {
        return control(droneId, ControlAction.TAKE, ControlRequestView.NOTHING);
    }

    @Override
    public SoapControl takeOverControl(String droneId, @Nullable String reason) throws DronemapFault {
        return control(droneId, ControlAction.TAKE_OVER, new ControlRequestView(reason, null, null));
    }

    @Override
    public SoapControl handControlOver(String droneId, @Nullable String user) throws DronemapFault {
        return control(droneId, ControlAction.HAND_OVER, new ControlRequestView(null, user, null));
    }

    @Override
    public SoapControl controlHeartbeat(String droneId, @Nullable Long epoch) throws DronemapFault {
        return control(droneId, ControlAction.HEARTBEAT, new ControlRequestView(null, null, epoch));
    }

    @Override
    public SoapControl giveControlBack(String droneId) throws DronemapFault {
        return control(droneId, ControlAction.RELEASE, ControlRequestView.NOTHING);
    }

    private SoapControl control(String droneId, ControlAction action, ControlRequestView with) throws DronemapFault {
        return answer(() -> SoapControl.of(
                controls.act(caller.principal(), droneId, action, with).control()));
    }

    @Override
    public SoapPlan planMission(
            @Nullable List<String> droneIds,
            @Nullable List<SoapVisit> visits,
            @Nullable SoapObjective objective,
            @Nullable SoapWind wind,
            @Nullable Double seconds)
            throws DronemapFault {
        return answer(() -> plans.ask(new SoapPlans.Wish(droneIds, visits, objective, wind, seconds)));
    }

    @Override
    public SoapPlan getPlan(String planId) throws DronemapFault {
        return answer(() -> plans.plan(planId));
    }

    @Override
    public SoapPlan acceptPlan(String planId, @Nullable Boolean start, @Nullable String onCloudLoss)
            throws DronemapFault {
        return answer(() -> plans.accept(planId, start, onCloudLoss));
    }

    @Override
    public SoapPlan stopPlan(String planId) throws DronemapFault {
        return answer(() -> plans.stop(planId));
    }

    @Override
    public void cancelPlan(String planId) throws DronemapFault {
        answer(() -> {
            plans.cancel(planId);
            return planId;
        });
    }

    @Override
    public SoapRun startRun(String planId, @Nullable String mode, @Nullable String onCloudLoss, @Nullable String name)
            throws DronemapFault {
        return answer(() -> runs.start(planId, mode, onCloudLoss, name));
    }

    @Override
    public List<SoapRun> getRunsList() throws DronemapFault {
        return answer(runs::all);
    }

    @Override
    public SoapRun getRun(String runId) throws DronemapFault {
        return answer(() -> runs.run(runId));
    }

    @Override
    public SoapRun addRunWaypoint(String runId, @Nullable List<SoapVisit> visits) throws DronemapFault {
        return answer(() -> runs.add(runId, visits));
    }

    @Override
    public SoapRun resumeRunDrone(String runId, @Nullable String droneId) throws DronemapFault {
        return answer(() -> runs.resume(runId, droneId));
    }

    @Override
    public SoapRun answerRun(String runId, @Nullable Integer proposal, @Nullable Boolean accept) throws DronemapFault {
        return answer(() -> runs.answer(runId, proposal, accept));
    }

    @Override
    public SoapRun pauseRun(String runId) throws DronemapFault {
        return answer(() -> runs.pause(runId));
    }

    @Override
    public SoapRun continueRun(String runId) throws DronemapFault {
        return answer(() -> runs.goOn(runId));
    }

    @Override
    public SoapRun stopRun(String runId) throws DronemapFault {
        return answer(() -> runs.stop(runId));
    }

    @Override
    public List<SoapVirtualDrone> getVirtualDronesList() throws DronemapFault {
        return answer(virtuals::all);
    }

    @Override
    public SoapVirtualDrone getVirtualDrone(String virtualDroneId) throws DronemapFault {
        return answer(() -> virtuals.one(virtualDroneId));
    }

    @Override
    public SoapVirtualDrone createVirtualDrone(
            @Nullable String name,
            @Nullable String kind,
            @Nullable Integer enduranceMinutes,
            @Nullable List<String> needs,
            @Nullable List<SoapWaypoint> waypoints)
            throws DronemapFault {
        return answer(() -> virtuals.make(new SoapVirtualDrones.Wish(name, kind, enduranceMinutes, needs, waypoints)));
    }

    @Override
    public SoapVirtualDrone startVirtualDrone(String virtualDroneId, @Nullable String onCloudLoss)
            throws DronemapFault {
        return answer(() -> virtuals.start(virtualDroneId, onCloudLoss));
    }

    @Override
    public SoapVirtualDrone stopVirtualDrone(String virtualDroneId) throws DronemapFault {
        return answer(() -> virtuals.stop(virtualDroneId));
    }

    @Override
    public SoapVirtualDrone resumeVirtualDrone(String virtualDroneId) throws DronemapFault {
        return answer(() -> virtuals.resume(virtualDroneId));
    }

    @Override
    public void removeVirtualDrone(String virtualDroneId) throws DronemapFault {
        answer(() -> {
            virtuals.remove(virtualDroneId);
            return virtualDroneId;
        });
    }

    @Override
    public List<SoapFlight> getFlightsList(
            @Nullable String droneId,
            @Nullable String user,
            @Nullable String from,
            @Nullable String until,
            @Nullable String words,
            @Nullable String before)
            throws DronemapFault {
        return answer(() -> flights.some(new FlightSearch(droneId, user, from, until, words), before));
    }

    @Override
    public SoapFlight getFlight(String flightId) throws DronemapFault {
        return answer(() -> flights.one(flightId));
    }

    @Override
    public SoapOutcome getCommand(String commandId) throws DronemapFault {
        return answer(() -> actions.one(commandId));
    }
}
