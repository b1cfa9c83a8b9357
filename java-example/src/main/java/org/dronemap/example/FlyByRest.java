package org.dronemap.example;

import static org.dronemap.example.RestCalls.orProblem;

import java.util.List;
import org.dronemap.example.rest.DronesApi;
import org.dronemap.example.rest.model.ControlView;
import org.dronemap.example.rest.model.DroneLinkView;
import org.dronemap.example.rest.model.DroneView;

/**
 * Flies one drone by REST: up to 10 m, 30 m north, and home. The argument is its id or its name; without one it is the
 * first drone that is ready.
 */
public final class FlyByRest {
    private static final double HEIGHT_METERS = 10;
    private static final double LEG_METERS = 30;

    private FlyByRest() {}

    public static void main(String[] arguments) {
        Program.run(() -> fly(arguments));
    }

    private static void fly(String[] arguments) throws FlightException {
        Connection connection = Connection.fromEnvironment();
        DroneView chosen = chosen(connection, arguments);
        if (chosen.getHome() == null) {
            throw new FlightException(chosen.getName() + " has not told yet where its home is.");
        }
        Place home = new Place(chosen.getHome().getLatitude(), chosen.getHome().getLongitude());

        try (RestDrone drone = new RestDrone(connection, chosen.getId())) {
            System.out.println(chosen.getName() + ": arm");
            drone.arm();
            System.out.println("Take off");
            drone.takeOff(HEIGHT_METERS);
            System.out.println("Fly north");
            drone.goTo(home.north(LEG_METERS), HEIGHT_METERS);
            System.out.println("Return home");
            drone.returnHome();
            System.out.println("Landed");
        }
    }

    private static DroneView chosen(Connection connection, String[] arguments) throws FlightException {
        DronesApi drones = new DronesApi(RestCalls.client(connection));
        List<DroneView> all = orProblem(() -> drones.listDrones(null)).getDrones();
        if (arguments.length == 0) {
            return all.stream()
                    .filter(FlyByRest::isReady)
                    .findFirst()
                    .orElseThrow(() -> new FlightException("No drone is ready to arm."));
        }
        return all.stream()
                .filter(drone -> arguments[0].equals(drone.getId()) || arguments[0].equals(drone.getName()))
                .findFirst()
                .orElseThrow(() -> new FlightException("There is no drone " + arguments[0] + "."));
    }

    private static boolean isReady(DroneView drone) {
        return drone.getLink().getState() == DroneLinkView.StateEnum.LIVE
                && !drone.getReplay()
                && drone.getControl().getState() == ControlView.StateEnum.FREE
                && Boolean.FALSE.equals(drone.getArmed())
                && Boolean.TRUE.equals(drone.getReadyToArm())
                && drone.getHome() != null;
    }
}
