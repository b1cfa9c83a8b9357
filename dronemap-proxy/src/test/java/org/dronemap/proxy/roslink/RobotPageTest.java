package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.EmergencyStop;
import org.dronemap.core.command.GoToLocal;
import org.dronemap.core.command.ReadMap;
import org.dronemap.proxy.roslink.wire.PacketLayout;
import org.dronemap.proxy.roslink.wire.PacketReadResult;
import org.dronemap.proxy.roslink.wire.RobotOrder;
import org.dronemap.proxy.roslink.wire.RobotOrderWriter;
import org.dronemap.proxy.roslink.wire.RoslinkHeader;
import org.dronemap.proxy.roslink.wire.RoslinkPacketReader;
import org.dronemap.proxy.roslink.wire.StringOrNumber;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** What the page on connecting a robot says of messages, types and waits is what the code reads, writes and waits. */
class RobotPageTest {
    private static final JsonMapper MAPPER = JsonMapper.shared();
    private static final Pattern NAME = Pattern.compile("`(\\w+)`");
    private static final Pattern NUMBER = Pattern.compile("\\d+");
    private static final int PICTURE = 5;

    private static final List<RobotOrder> ORDERS = List.of(
            new RobotOrder.Heartbeat(),
            RobotOrder.Twist.STOP,
            new RobotOrder.GoTo(1, 2, 0, false),
            new RobotOrder.TakeOff(10),
            new RobotOrder.Land(),
            new RobotOrder.Arm(),
            new RobotOrder.Disarm(),
            new RobotOrder.SetMode(4),
            new RobotOrder.GetMap(),
            new RobotOrder.EmergencyStop());

    private static final Map<String, Command> COMMANDS = Map.ofEntries(
            Map.entry("arm", new Command.Arm()),
            Map.entry("disarm", new Command.Disarm(false)),
            Map.entry("setMode", new Command.SetMode("GUIDED")),
            Map.entry("returnToLaunch", new Command.ReturnToLaunch()),
            Map.entry("hold", new Command.Hold()),
            Map.entry("emergencyStop", new EmergencyStop()),
            Map.entry("readMap", new ReadMap()),
            Map.entry("takeOff", new Command.TakeOff(10)),
            Map.entry("land", new Command.Land()),
            Map.entry("goToLocal", new GoToLocal(1, 2, null)));

    /** The cells of the first table behind a heading, or behind the table's own first line. */
    private static List<String[]> table(String before) throws IOException {
        return Files.readAllLines(Path.of("../docs/jobs/connect-a-robot.md")).stream()
                .dropWhile(line -> !line.startsWith(before))
                .dropWhile(line -> !line.startsWith("| --- "))
                .skip(1)
                .takeWhile(line -> line.startsWith("|"))
                .map(line -> Stream.of(line.substring(1).split("\\|"))
                        .map(String::trim)
                        .toArray(String[]::new))
                .toList();
    }

    private static List<String> names(String cell) {
        return all(NAME, cell, found -> found.group(1));
    }

    private static <T> List<T> all(Pattern pattern, String cell, Function<MatchResult, T> taken) {
        return pattern.matcher(cell).results().map(taken).toList();
    }

    @Test
    void saysWhichFieldsOfAMessageAreRead() throws IOException {
        List<String[]> rows = table("### What the bridge sends");
        assertThat(rows).hasSize(8);
        for (String[] row : rows) {
            int id = Integer.parseInt(row[0]);
            // Two names for one thing: either is read.
            List<String> names =
                    names(row[3]).stream().filter(name -> !name.equals("yaw")).toList();
            PacketReadResult whole = read(id, names);
            String said = whole.toString().replace(id == PICTURE ? "view=null" : "", "");
            assertThat(said.substring(said.indexOf("message="))).as(row[1]).doesNotContain("null");
            for (String left : names) {
                List<String> others =
                        names.stream().filter(name -> !name.equals(left)).toList();
                assertThat(read(id, others)).as(row[1] + " without " + left).isNotEqualTo(whole);
            }
        }
    }

    private static PacketReadResult read(int id, List<String> names) {
        ObjectNode message = MAPPER.createObjectNode();
        message.putObject("header").put("system_id", 7).put("message_id", id);
        names.forEach(name -> {
            switch (name) {
                case "data", "name" -> message.put(name, "iVBORw==");
                case "ranges" -> message.putArray(name).add(1.5);
                default -> message.put(name, 1);
            }
        });
        return new RoslinkPacketReader().read(ByteBuffer.wrap(message.toString().getBytes(StandardCharsets.UTF_8)));
    }

    @Test
    void saysWhichOrdersARobotIsSentWithWhichFields() throws IOException {
        Map<Integer, List<String>> said = table("### What the bridge is sent").stream()
                .collect(Collectors.toMap(row -> Integer.valueOf(row[0]), row -> names(row[3])));
        Map<Integer, List<String>> sent =
                ORDERS.stream().collect(Collectors.toMap(RobotOrder::messageId, RobotPageTest::fields));

        assertThat(ORDERS).hasSize(RobotOrder.class.getPermittedSubclasses().length);
        assertThat(said).isEqualTo(sent);
    }

    private static List<String> fields(RobotOrder order) {
        RoslinkHeader robot =
                new RoslinkHeader(PacketLayout.NESTED_HEADER, 7, 0, 1L, null, new StringOrNumber("26", false), 2, 2);
        return MAPPER.readTree(new RobotOrderWriter().write(robot, order)).propertyNames().stream()
                .filter(name -> !name.equals("header"))
                .toList();
    }

    @Test
    void saysWhichTypesOfRobotsThereAre() throws IOException {
        List<List<Integer>> said = table("`z` of a ground robot").stream()
                .map(row -> all(NUMBER, row[0], found -> Integer.valueOf(found.group())))
                .toList();
        assertThat(said).hasSize(3);
        assertThat(said.stream().flatMap(List::stream)).hasSize(RobotType.values().length);
        for (int number : said.get(0)) {
            assertThat(RobotType.of(number).words().flies())
                    .as("type " + number)
                    .isFalse();
        }
        assertThat(said.get(1))
                .allSatisfy(number -> assertThat(RobotType.of(number).words()).isEqualTo(RobotType.Dialect.MAVROS));
        assertThat(said.get(2))
                .allSatisfy(number -> assertThat(RobotType.of(number).words()).isEqualTo(RobotType.Dialect.AR_DRONE));
    }

    @Test
    void saysHowLongACommandMayTake() throws IOException {
        Map<String, List<Long>> said = table("### How a command to a robot ends").stream()
                .flatMap(row -> names(row[0]).stream().map(name -> Map.entry(name, row[1])))
                .collect(Collectors.toMap(
                        Map.Entry::getKey,
                        entry -> all(NUMBER, entry.getValue(), found -> Long.valueOf(found.group()))));
        assertThat(said).containsOnlyKeys(COMMANDS.keySet());
        said.forEach((name, seconds) -> {
            RobotGoal goal = goal(COMMANDS.get(name));
            assertThat(seconds.get(0)).as(name).isEqualTo(seconds(goal.patienceNanos()));
        });
        assertThat(said.get("goToLocal").get(1))
                .isEqualTo(seconds(goal(COMMANDS.get("goToLocal")).idlePatienceNanos()));
        List<Long> takeOff = said.get("takeOff");
        assertThat(Arrays.asList(takeOff.get(1) + 2 * takeOff.get(2), takeOff.get(3)))
                .containsExactly(
                        seconds(goal(new Command.TakeOff(2)).patienceNanos()),
                        seconds(goal(new Command.TakeOff(500)).patienceNanos()));
    }

    private static RobotGoal goal(Command command) {
        return Optional.ofNullable(command).flatMap(RobotGoal::of).orElseThrow();
    }

    private static long seconds(long nanos) {
        return nanos / RobotGoal.SECOND_NANOS;
    }
}
