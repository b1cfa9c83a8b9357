package org.dronemap.example;

import static org.dronemap.example.SoapCalls.orProblem;

import java.util.List;
import org.dronemap.example.soap.MAVLinkActionWebService;
import org.dronemap.example.soap.model.DroneView;

/**
 * Flies one drone by SOAP: up to 10 m, 30 m north, and home. The argument is its id or its name; without one it is the
 * first drone that is ready.
 */
public final class FlyBySoap {
    private static final double HEIGHT_METERS = 10;
    private static final double LEG_METERS = 30;

    private FlyBySoap() {}

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

        try (SoapDrone drone = new SoapDrone(connection, chosen.getId())) {
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
        MAVLinkActionWebService service = SoapCalls.service(connection, SoapCalls.LONGEST);
        List<DroneView> all =
                orProblem(() -> service.getDronesList(null)).getDrones().getItem();
        if (arguments.length == 0) {
            return all.stream()
                    .filter(FlyBySoap::isReady)
                    .findFirst()
                    .orElseThrow(() -> new FlightException("No drone is ready to arm."));
        }
        return all.stream()
                .filter(drone -> arguments[0].equals(drone.getId()) || arguments[0].equals(drone.getName()))
                .findFirst()
                .orElseThrow(() -> new FlightException("There is no drone " + arguments[0] + "."));
    }

    private static boolean isReady(DroneView drone) {
        return drone.getLink().getState().equals("live")
                && !drone.isReplay()
                && drone.getControl().getState().equals("free")
                && Boolean.FALSE.equals(drone.isArmed())
                && Boolean.TRUE.equals(drone.isReadyToArm())
                && drone.getHome() != null;
    }
}
