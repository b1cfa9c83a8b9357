package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dronemap.core.cloud.rule.CommandTimeoutWatch;
import org.dronemap.core.cloud.rule.CommandTracker;
import org.dronemap.core.command.ChangeSpeed;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.ReadHome;
import org.dronemap.core.command.RelaySetting;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The page on flying a drone says how long a command waits: measured with vehicles that answer nothing more. */
class WaitingTimesTableTest {
    private static final int ACCEPTED = 0;
    private static final int IN_PROGRESS = 5;
    private static final double LATEST_SECONDS = 0.2;
    private static final Heartbeat GUIDED = new Heartbeat(2, 3, 81, 4, 3, 3);
    private static final Heartbeat ARMED = new Heartbeat(2, 3, 81 | 128, 4, 3, 3);
    private static final Heartbeat PX4_IN_POSCTL = new Heartbeat(2, 12, 81, 3 << 16, 3, 3);

    /** A command to a vehicle that stands so. */
    record Given(Heartbeat vehicle, Command command) {}

    private static final Map<String, Given> COMMANDS = Map.ofEntries(
            Map.entry("arm", new Given(GUIDED, new Command.Arm())),
            Map.entry("disarm", new Given(ARMED, new Command.Disarm(false))),
            Map.entry("setMode", new Given(GUIDED, new Command.SetMode("LOITER"))),
            Map.entry("land", new Given(GUIDED, new Command.Land())),
            Map.entry("returnToLaunch", new Given(GUIDED, new Command.ReturnToLaunch())),
            Map.entry("hold", new Given(PX4_IN_POSCTL, new Command.Hold())),
            Map.entry("pauseMission", new Given(PX4_IN_POSCTL, new Command.PauseMission())),
            Map.entry("takeOff", new Given(GUIDED, new Command.TakeOff(10))),
            Map.entry("goTo", new Given(GUIDED, new Command.GoTo(new Geodetic(47, 8), Altitude.aboveHome(10)))),
            Map.entry("turn", new Given(GUIDED, new Command.Turn(90))),
            Map.entry("changeSpeed", new Given(GUIDED, new ChangeSpeed(5))),
            Map.entry("takePicture", new Given(GUIDED, new Command.TakePicture())),
            Map.entry("setRelay", new Given(GUIDED, new Command.SetRelay(0, RelaySetting.ON))));

    /** One command of the first table: seconds and end of a silent vehicle, and of one that accepts; "–" for none. */
    record Row(String command, String unanswered, String unansweredEnd, String unseen, String unseenEnd) {}

    private static List<String[]> rows(int columns) throws IOException {
        return Files.readAllLines(Path.of("../docs/jobs/fly-a-drone.md")).stream()
                .dropWhile(line -> !line.startsWith("### Command timeout:"))
                .skip(1)
                .takeWhile(line -> !line.startsWith("#"))
                .filter(line -> line.startsWith("| ") && !line.startsWith("| ---"))
                .map(line -> Stream.of(line.substring(1).split("\\|"))
                        .map(String::trim)
                        .toArray(String[]::new))
                .filter(row -> row.length == columns && !row[1].startsWith("seconds"))
                .toList();
    }

    static List<Row> commands() throws IOException {
        return rows(5).stream()
                .flatMap(row -> Pattern.compile("`(\\w+)`")
                        .matcher(row[0])
                        .results()
                        .map(name -> new Row(name.group(1), row[1], row[2], row[3], row[4])))
                .toList();
    }

    private static String words(Outcome.Kind kind) {
        return kind == Outcome.Kind.TIMED_OUT ? "timed out" : kind.name().toLowerCase(Locale.ROOT);
    }

    private static void endsSo(AutopilotTestBench bench, Supplier<Outcome> perform, String seconds, String end) {
        long before = bench.wire.now();
        Outcome outcome = perform.get();
        double waited = (bench.wire.now() - before) / 1e9;
        assertThat(words(outcome.kind())).as(outcome.reason()).isEqualTo(end);
        double said = Double.parseDouble(seconds);
        assertThat(waited).as(outcome.reason()).isBetween(said, said + LATEST_SECONDS);
    }

    private static void answer(AutopilotTestBench bench, int result) {
        bench.wire.peer((wire, message) -> wire.answer(new CommandAck(command(message), result, 0, 0, 255, 190)));
    }

    private static int command(Message message) {
        return message instanceof CommandLong whole ? whole.command() : ((CommandInt) message).command();
    }

    @ParameterizedTest
    @MethodSource("commands")
    void saysHowLongACommandWaits(Row row) {
        Given given = Objects.requireNonNull(COMMANDS.get(row.command()), row.command());
        AutopilotTestBench silent = new AutopilotTestBench(given.vehicle());
        endsSo(
                silent,
                () -> Objects.requireNonNull(silent.perform(given.command())),
                row.unanswered(),
                row.unansweredEnd());

        AutopilotTestBench accepting = new AutopilotTestBench(given.vehicle());
        accepting.wire.chatter(true);
        answer(accepting, ACCEPTED);
        boolean acknowledgedIsDone = row.unseen().equals("–");
        endsSo(
                accepting,
                () -> Objects.requireNonNull(accepting.perform(given.command())),
                acknowledgedIsDone ? "0" : row.unseen(),
                acknowledgedIsDone ? "succeeded" : row.unseenEnd());
    }

    @Test
    void saysItOfEachOfThem() throws IOException {
        assertThat(commands()).extracting(Row::command).containsExactlyInAnyOrderElementsOf(COMMANDS.keySet());
    }

    @Test
    void saysTheOtherWaits() throws IOException {
        List<String[]> waits = rows(3);
        assertThat(waits).hasSize(4);
        assertThat(waits.get(0)[1]).isEqualTo(String.valueOf(CommandTracker.LONGEST_WAY.toSeconds()));
        assertThat(waits.get(0)[2]).isEqualTo(words(CommandTracker.LATE.kind()));

        AutopilotTestBench beginning = new AutopilotTestBench(GUIDED);
        beginning.wire.peer((wire, message) -> {
            wire.answer(new CommandAck(command(message), IN_PROGRESS, 0, 0, 255, 190));
            wire.peer((later, more) -> {});
        });
        endsSo(
                beginning,
                () -> Objects.requireNonNull(beginning.perform(new Command.Arm())),
                waits.get(1)[1],
                waits.get(1)[2]);

        AutopilotTestBench cut = new AutopilotTestBench(GUIDED);
        endsSo(cut, () -> Objects.requireNonNull(cut.perform(new ReadHome())), waits.get(2)[1], waits.get(2)[2]);

        assertThat(waits.get(3)[1]).isEqualTo(String.valueOf(CommandTimeoutWatch.LONGEST_SILENCE.toSeconds()));
        assertThat(waits.get(3)[2]).isEqualTo("unknown");
    }
}
