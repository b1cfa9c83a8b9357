package org.dronemap.sim;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.util.List;
import org.dronemap.sim.control.SimulatorControlPort;
import org.dronemap.sim.link.SimulatedFleet;
import org.dronemap.sim.robot.RobotOptions;
import org.dronemap.sim.robot.SimulatedRobotFleet;

/** The entry point of the vehicle simulator: starts simulated vehicles or robots that connect to a server. */
public final class SimulatorMain {
    private static final int BAD_USAGE = 2;

    private SimulatorMain() {}

    public static void main(String[] arguments) {
        int code = run(List.of(arguments), System.out, System.err);
        if (code != 0) {
            System.exit(code);
        }
    }

    /** The exit code; 0 also when the fleet has been started and goes on running. */
    static int run(List<String> arguments, PrintStream out, PrintStream err) {
        if (arguments.contains("--help")) {
            out.print(SimulatorOptions.HELP + RobotOptions.HELP);
            return 0;
        }
        try {
            if (arguments.contains("--roslink")) {
                startRobots(RobotOptionsReader.read(arguments), out);
            } else {
                start(SimulatorOptions.parse(arguments), out);
            }
            return 0;
        } catch (IllegalArgumentException e) {
            err.println(e.getMessage());
            return BAD_USAGE;
        } catch (IOException | UncheckedIOException e) {
            err.println("The simulator cannot start: " + e.getMessage());
            return 1;
        }
    }

    private static void startRobots(RobotOptions options, PrintStream out) throws IOException {
        new SimulatedRobotFleet(options).start();
        out.println(options.count() + (options.count() == 1 ? " robot reports to udp://" : " robots report to udp://")
                + options.server().host() + ":" + options.server().port());
    }

    private static void start(SimulatorOptions options, PrintStream out) throws IOException {
        SimulatedFleet fleet = new SimulatedFleetBuilder(options, System.currentTimeMillis() * 1000).build();
        if (options.controlPort() != 0) {
            SimulatorControlPort control = new SimulatorControlPort(fleet, options.controlPort());
            out.println("Faults are taken at 127.0.0.1:" + control.port());
        }
        fleet.start();
        out.println(options.count() + (options.count() == 1 ? " vehicle reports to " : " vehicles report to ")
                + (options.server().tcp() ? "tcp://" : "udp://")
                + options.server().host() + ":" + options.server().port());
    }
}
