package org.dronemap.sim;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.dronemap.sim.flight.SimulatedMissionItem;

/** Which mission items a real ArduPilot was sent, and what it answered and gave back; recorded of each vehicle. */
record RecordedItems(List<Probe> probes) {
    /** One item that was sent; {@code read} is null when it was not taken. */
    record Probe(String name, SimulatedMissionItem sent, long ack, RecordedLine line) {
        @Override
        public String toString() {
            return name;
        }
    }

    static RecordedItems of(String vehicle) {
        List<RecordedLine> lines = RecordedLine.readFile("items/" + vehicle);
        Map<String, RecordedLine> contents = lines.stream()
                .filter(line -> !line.text("content").isEmpty())
                .collect(Collectors.toMap(line -> line.text("content"), line -> line));
        return new RecordedItems(lines.stream()
                .filter(line -> line.text("content").isEmpty())
                .map(line -> probe(line, contents.get(line.text("sent"))))
                .toList());
    }

    private static Probe probe(RecordedLine line, RecordedLine content) {
        int command = (int) line.integer("command");
        return new Probe(command + " " + line.text("sent"), item(command, content, ""), line.integer("ack"), line);
    }

    private static SimulatedMissionItem item(int command, RecordedLine line, String prefix) {
        return new SimulatedMissionItem(
                command,
                (int) line.integer(prefix + "frame"),
                1,
                line.number(prefix + "param1"),
                line.number(prefix + "param2"),
                line.number(prefix + "param3"),
                line.number(prefix + "param4"),
                (int) line.integer(prefix + "x"),
                (int) line.integer(prefix + "y"),
                line.number(prefix + "z"));
    }

    /** What was read back. */
    static SimulatedMissionItem read(Probe probe) {
        return item((int) probe.line().integer("read_command"), probe.line(), "read_");
    }
}
