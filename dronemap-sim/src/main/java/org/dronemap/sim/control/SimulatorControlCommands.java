package org.dronemap.sim.control;

import java.util.List;
import java.util.Locale;
import org.dronemap.sim.autopilot.SimulatedCommandResult;
import org.dronemap.sim.autopilot.SimulatedPayload;
import org.dronemap.sim.autopilot.SimulatedVehicle;
import org.dronemap.sim.flight.SimulatedCraft;

/**
 * Executes test commands of the simulator's control port; each answer begins with "ok" or "err". On the fleet's thread.
 */
public final class SimulatorControlCommands {
    static final String HELP = """
            list                                  all vehicles
            where                                 true place of each: latitude and longitude, metres above home
            payload                               pictures taken, relays switched on and servos moved by each
            sensor <sysid|all> <name> <value>     has a sensor that measures that from now on; off instead of name and
                                                  value: has none any more
            signing                               who has a signing key, and how many frames each did not listen to
            wake <sysid|all>                      talks and listens from now on
            fault <sysid|all> silent <seconds>s   stops talking and listening for a while
            text <sysid|all> <who> <words>        sends that text, in pieces if it is long; who: vehicle or a companion
            companions <sysid|all> <names|none>   who else speaks on its link: gimbal, camera, computer, adsb, station
            fault <sysid|all> gps off|on|<sec>s   loses or regains GPS, or loses it for so long
            fault <sysid|all> battery-unknown on|off
                                                  its battery's monitor stops measuring
            fault <sysid|all> battery <percent>   sets what the battery has left
            fault <sysid|all> crash               falls out of the sky and stays broken
            fault <sysid|all> motor-failure       one motor stops: falls and stays armed
            fault <sysid|all> reboot              restarts with a new port
            fault <sysid|all> gcs-ignore on|off   hears nothing from the ground, goes on talking
            fault <sysid|all> stick low|mid       throttle stick of the remote control
            fault <sysid|all> mode <NUMBER>       that mode (as in custom_mode), by the pilot's own switch
            fault <sysid|all> alter <NAME|NUMBER> keeps that parameter, or the altitude of that mission item (home is 0),
                                                  otherwise than it is told, without a word
            fault <sysid|all> repair              takes crash, motor failure and alterations back
            ok end of help""";

    private SimulatorControlCommands() {}

    public static String run(String line, List<SimulatedVehicle> vehicles) {
        String[] words = line.trim().toLowerCase(Locale.ROOT).split("\\s+");
        return switch (words[0]) {
            case "help" -> HELP;
            case "list" -> list(vehicles);
            case "where" -> where(vehicles);
            case "payload" -> payload(vehicles);
            case "signing" -> signing(vehicles);
            case "sensor" -> sensor(words, line.trim().split("\\s+"), vehicles);
            case "wake" -> wake(words, vehicles);
            case "text" -> CompanionCommands.text(line.trim(), chosen(words, vehicles));
            case "companions" -> CompanionCommands.companions(words, chosen(words, vehicles));
            case "fault" -> fault(words, vehicles);
            default -> "err unknown word '" + words[0] + "': say help";
        };
    }

    private static String list(List<SimulatedVehicle> vehicles) {
        StringBuilder text = new StringBuilder();
        for (SimulatedVehicle vehicle : vehicles) {
            SimulatedCraft craft = vehicle.craft();
            text.append(String.format(
                    Locale.ROOT,
                    "%d %s %s %s %.1f m %.1f m/s battery %.0f %%%n",
                    vehicle.systemId(),
                    vehicle.kindName(),
                    craft.armed() ? "armed" : "disarmed",
                    craft.landed() ? "landed" : "flying",
                    craft.aboveHome(),
                    craft.body().groundSpeed(),
                    craft.battery().remainingPercent()));
        }
        return text + "ok " + vehicles.size() + " vehicles";
    }

    private static String where(List<SimulatedVehicle> vehicles) {
        StringBuilder text = new StringBuilder();
        for (SimulatedVehicle vehicle : vehicles) {
            SimulatedCraft craft = vehicle.craft();
            text.append(String.format(
                    Locale.ROOT,
                    "%d %.7f %.7f %.2f%n",
                    vehicle.systemId(),
                    craft.frame().latitudeOf(craft.truePosition()),
                    craft.frame().longitudeOf(craft.truePosition()),
                    craft.aboveHome() - craft.noise().height()));
        }
        return text + "ok " + vehicles.size() + " vehicles";
    }

    private static String wake(String[] words, List<SimulatedVehicle> vehicles) {
        List<SimulatedVehicle> chosen = words.length == 2 ? chosen(words[1], vehicles) : List.of();
        chosen.forEach(vehicle -> vehicle.silence(0));
        return chosen.isEmpty()
                ? "err say wake <sysid|all>, of vehicles that there are"
                : "ok " + chosen.size() + " vehicles";
    }

    private static String payload(List<SimulatedVehicle> vehicles) {
        StringBuilder text = new StringBuilder();
        for (SimulatedVehicle vehicle : vehicles) {
            text.append(String.format(
                    Locale.ROOT,
                    "%d %s%n",
                    vehicle.systemId(),
                    vehicle.autopilot().payload().words()));
        }
        return text + "ok " + vehicles.size() + " vehicles";
    }

    private static String signing(List<SimulatedVehicle> vehicles) {
        StringBuilder text = new StringBuilder();
        for (SimulatedVehicle vehicle : vehicles) {
            text.append(String.format(
                    Locale.ROOT,
                    "%d %s refused %d%n",
                    vehicle.systemId(),
                    vehicle.signing().isOn() ? "signs" : "unsigned",
                    vehicle.signing().refused()));
        }
        return text + "ok " + vehicles.size() + " vehicles";
    }

    /** {@code written}: with the case of names as they were written. */
    private static String sensor(String[] words, String[] written, List<SimulatedVehicle> vehicles) {
        boolean off = words.length == 3 && words[2].equals("off");
        double value = words.length == 4 ? number(words[3]) : Double.NaN;
        if (!off && !Double.isFinite(value)) {
            return "err say sensor <sysid|all> <name> <value>, or off instead of name and value";
        }
        List<SimulatedVehicle> chosen = chosen(words[1], vehicles);
        for (SimulatedVehicle vehicle : chosen) {
            SimulatedPayload payload = vehicle.autopilot().payload();
            if (off) {
                payload.forgetSensors();
            } else {
                payload.measure(written[2], (float) value);
            }
        }
        return chosen.isEmpty()
                ? "err no vehicle has system id " + words[1] + ": say list"
                : "ok " + chosen.size() + " vehicles";
    }

    private static List<SimulatedVehicle> chosen(String[] words, List<SimulatedVehicle> vehicles) {
        return words.length < 2 ? List.of() : chosen(words[1], vehicles);
    }

    private static String gps(SimulatedVehicle vehicle, String value) {
        if (!value.matches("\\d{1,5}s")) {
            return onOff("gps", value, on -> vehicle.craft().navigation().setReceiving(on));
        }
        vehicle.craft().navigation().lose(Long.parseLong(value.substring(0, value.length() - 1)) * 1000);
        return "";
    }

    private static List<SimulatedVehicle> chosen(String which, List<SimulatedVehicle> vehicles) {
        return vehicles.stream()
                .filter(v -> which.equals("all") || which.equals(Integer.toString(v.systemId())))
                .toList();
    }

    private static String fault(String[] words, List<SimulatedVehicle> vehicles) {
        if (words.length < 3) {
            return "err say fault <sysid|all> <what>, or help";
        }
        List<SimulatedVehicle> chosen = chosen(words[1], vehicles);
        if (chosen.isEmpty()) {
            return "err no vehicle has system id " + words[1] + ": say list";
        }
        String value = words.length > 3 ? words[3] : "";
        for (SimulatedVehicle vehicle : chosen) {
            String wrong = apply(vehicle, words[2], value);
            if (!wrong.isEmpty()) {
                return "err " + wrong;
            }
        }
        return "ok " + words[2] + (value.isEmpty() ? "" : " " + value) + " for " + chosen.size()
                + (chosen.size() == 1 ? " vehicle" : " vehicles");
    }

    /** Empty when done, else what is wrong. */
    private static String apply(SimulatedVehicle vehicle, String what, String value) {
        return switch (what) {
            case "silent" -> silence(vehicle, value);
            case "gps" -> gps(vehicle, value);
            case "battery-unknown" -> onOff(what, value, vehicle::setBatteryUnknown);
            case "battery" -> battery(vehicle, value);
            case "crash" -> done(vehicle.craft()::crash);
            case "motor-failure" -> done(vehicle.craft()::failMotor);
            case "repair" ->
                done(() -> {
                    vehicle.craft().repair();
                    vehicle.alterations().clear();
                });
            case "alter" -> alter(vehicle, value);
            case "reboot" -> done(vehicle::reboot);
            case "gcs-ignore" -> onOff(what, value.isEmpty() ? "on" : value, vehicle::setDeaf);
            case "stick" -> stick(vehicle, value);
            case "mode" -> mode(vehicle, value);
            default -> "unknown fault '" + what + "': say help";
        };
    }

    private static String done(Runnable action) {
        action.run();
        return "";
    }

    private static String alter(SimulatedVehicle vehicle, String value) {
        if (value.matches("\\d{1,4}")) {
            vehicle.alterations().alterItem(Integer.parseInt(value));
            return "";
        }
        String name = value.toUpperCase(Locale.ROOT);
        if (vehicle.autopilot().parameters().indexOf(name) < 0) {
            return "alter wants the name of a parameter or the number of a mission item, not '" + value + "'";
        }
        vehicle.alterations().alterParameter(name);
        return "";
    }

    private static String onOff(String what, String value, java.util.function.Consumer<Boolean> action) {
        if (!value.equals("on") && !value.equals("off")) {
            return what + " wants on or off, not '" + value + "'";
        }
        action.accept(value.equals("on"));
        return "";
    }

    private static String silence(SimulatedVehicle vehicle, String value) {
        double seconds = number(value.endsWith("s") ? value.substring(0, value.length() - 1) : value);
        if (!(seconds > 0 && seconds <= 86_400)) {
            return "silent wants seconds within 0 and 86400, such as 10s, not '" + value + "'";
        }
        vehicle.silence((long) (seconds * 1000));
        return "";
    }

    private static String battery(SimulatedVehicle vehicle, String value) {
        double percent = number(value);
        if (!(percent >= 0 && percent <= 100)) {
            return "battery wants a percentage within 0 and 100, not '" + value + "'";
        }
        vehicle.craft().battery().setRemainingPercent(percent);
        return "";
    }

    private static String stick(SimulatedVehicle vehicle, String value) {
        if (!value.equals("low") && !value.equals("mid")) {
            return "stick wants low or mid, not '" + value + "'";
        }
        vehicle.autopilot().stick(value.equals("low") ? 1000 : 1500);
        return "";
    }

    private static String mode(SimulatedVehicle vehicle, String value) {
        if (!value.matches("\\d{1,9}")) {
            return "mode wants the number of a mode, not '" + value + "'";
        }
        SimulatedCommandResult result = vehicle.autopilot().setMode(1, Long.parseLong(value));
        return result == SimulatedCommandResult.ACCEPTED ? "" : "mode " + value + " is not taken: " + result;
    }

    private static double number(String text) {
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }
}
