package org.dronemap.sim;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.sim.link.ServerAddress;
import org.dronemap.sim.physics.LocalFrame;
import org.jspecify.annotations.Nullable;

/** Parses the simulator's command line option by option; what is left at the end is an error. */
final class CommandLineReader {
    private final List<String> left;

    CommandLineReader(List<String> arguments) {
        this.left = new ArrayList<>(arguments);
    }

    boolean flag(String name) {
        return left.remove(name);
    }

    private @Nullable String removeValue(String name) {
        int at = left.indexOf(name);
        if (at < 0) {
            return null;
        }
        if (at + 1 >= left.size() || left.get(at + 1).startsWith("--")) {
            throw new IllegalArgumentException(name + " needs a value: say --help");
        }
        left.remove(at);
        return left.remove(at);
    }

    long integer(String name, long otherwise, long least, long most) {
        String text = removeValue(name);
        if (text == null) {
            return otherwise;
        }
        try {
            long value = Long.parseLong(text);
            if (value >= least && value <= most) {
                return value;
            }
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(name + " wants a whole number, not '" + text + "'", e);
        }
        throw new IllegalArgumentException(name + " " + text + " is not within " + least + " to " + most);
    }

    double number(String name, double otherwise, double least, double most) {
        String text = removeValue(name);
        if (text == null) {
            return otherwise;
        }
        double value = parse(name, text);
        if (!(value >= least && value <= most)) {
            throw new IllegalArgumentException(name + " " + text + " is not within " + least + " to " + most);
        }
        return value;
    }

    private static double parse(String name, String text) {
        try {
            return Double.parseDouble(text.trim());
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(name + " wants a number, not '" + text + "'", e);
        }
    }

    /** As often as it is given, each NAME=VALUE. */
    Map<String, Double> numbersByName(String name) {
        Map<String, Double> given = new LinkedHashMap<>();
        for (String text = removeValue(name); text != null; text = removeValue(name)) {
            int equals = text.indexOf('=');
            if (equals < 1) {
                throw new IllegalArgumentException(name + " wants NAME=VALUE, not '" + text + "'");
            }
            given.put(text.substring(0, equals), parse(name, text.substring(equals + 1)));
        }
        return given;
    }

    String choice(String name, String otherwise, List<String> choices) {
        String text = removeValue(name);
        if (text == null) {
            return otherwise;
        }
        if (!choices.contains(text)) {
            throw new IllegalArgumentException(
                    name + " is one of " + String.join(", ", choices) + ", not '" + text + "'");
        }
        return text;
    }

    String text(String name, String otherwise) {
        String text = removeValue(name);
        return text == null ? otherwise : text;
    }

    ServerAddress server(String name, ServerAddress otherwise) {
        String text = removeValue(name);
        return text == null ? otherwise : ServerAddress.parse(text);
    }

    LocalFrame home(String name, LocalFrame otherwise) {
        String text = removeValue(name);
        if (text == null) {
            return otherwise;
        }
        String[] parts = text.split(",", -1);
        if (parts.length < 2 || parts.length > 3) {
            throw new IllegalArgumentException(name + " wants LAT,LON or LAT,LON,ALTITUDE, not '" + text + "'");
        }
        double latitude = parse(name, parts[0]);
        double longitude = parse(name, parts[1]);
        double altitude = parts.length == 3 ? parse(name, parts[2]) : otherwise.altitudeAmsl();
        if (!(Math.abs(latitude) <= 85) || !(Math.abs(longitude) <= 180) || !(Math.abs(altitude) <= 6000)) {
            throw new IllegalArgumentException(name
                    + " wants a latitude within -85 to 85, a longitude within -180 to 180 and an altitude within -6000 to"
                    + " 6000, not '" + text + "'");
        }
        return new LocalFrame(latitude, longitude, altitude);
    }

    void finish() {
        if (!left.isEmpty()) {
            throw new IllegalArgumentException("unknown option '" + left.get(0) + "': say --help");
        }
    }
}
