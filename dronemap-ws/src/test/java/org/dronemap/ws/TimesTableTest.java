package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.regex.Pattern;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.safety.SafetyTimes;
import org.junit.jupiter.api.Test;

/** The table of times says what the code does, and each time is over before the next one counts. */
class TimesTableTest {
    private static final int WHAT = 1;
    private static final int SECONDS = 3;
    private static final int SET_BY = 5;
    private static final int MEASURED = 6;
    private static final Pattern SETTING = Pattern.compile("`(DRONEMAP_\\w+)`");
    private static final LeaseRules CONTROL = LeaseRules.DEFAULT;

    private static List<String[]> rows() throws IOException {
        return Files.readAllLines(Path.of("../docs/times.md")).stream()
                .filter(line -> line.startsWith("| ") && !line.startsWith("| what |") && !line.startsWith("| ---"))
                .map(line -> line.split("\\|", -1))
                .toList();
    }

    private static Duration said(String what) throws IOException {
        List<Duration> all = rows().stream()
                .filter(row -> row[WHAT].trim().equals(what))
                .map(row -> Duration.ofMillis(Math.round(1_000 * Double.parseDouble(row[SECONDS].trim()))))
                .distinct()
                .toList();
        assertThat(all).as(what).hasSize(1);
        return all.get(0);
    }

    @Test
    void saysWhatTheCodeDoes() throws IOException {
        assertThat(said("it is *suspect*")).isEqualTo(Watchdog.DEFAULT.suspectAfter());
        assertThat(said("it is *lost*")).isEqualTo(Watchdog.DEFAULT.lostAfter());
        assertThat(said("it comes home by itself"))
                .isEqualTo(said("a vehicle comes home by itself"))
                .isEqualTo(SafetyTimes.VEHICLE_RETURNS)
                .isEqualTo(Duration.ofSeconds(CloudManager.Rules.USUAL_LOSS_SECONDS));
        assertThat(said("what lies ahead of it is given to others"))
                .isEqualTo(Watchdog.DEFAULT.lostAfter().plus(SafetyTimes.CORRIDOR_FREED));
        assertThat(said("who took control is lost, and the drone holds")).isEqualTo(CONTROL.silence());
        assertThat(said("control that came with a command ends")).isEqualTo(CONTROL.idle());
        assertThat(said("from there: it is brought home")).isEqualTo(CONTROL.untilReturn());
    }

    @Test
    void eachIsOverBeforeTheNextCounts() throws IOException {
        assertThat(said("it is *suspect*")).isLessThan(said("it is *lost*"));
        assertThat(said("it is *lost*")).isLessThan(said("it comes home by itself"));
        assertThat(said("it is started again, and vehicles hear it"))
                .isGreaterThan(said("it is *lost*"))
                .isLessThan(said("a vehicle comes home by itself"));
        assertThat(said("it comes home by itself")).isLessThan(said("what lies ahead of it is given to others"));
        assertThat(said("others take over what it was to do")).isLessThan(said("it comes home by itself"));
    }

    @Test
    void whatWasMeasuredIsNoLaterThanASecond() throws IOException {
        for (String[] row : rows()) {
            String measured = row[MEASURED].trim();
            if (!measured.isEmpty()) {
                assertThat(Double.parseDouble(measured))
                        .as(row[WHAT])
                        .isLessThanOrEqualTo(Double.parseDouble(row[SECONDS].trim()) + 1);
            }
        }
    }

    @Test
    void namesSettingsThatThereAre() throws IOException {
        String settings = Files.readString(Path.of("../docs/settings.md"));
        List<String> named = rows().stream()
                .flatMap(row -> SETTING.matcher(row[SET_BY]).results())
                .map(found -> found.group(1))
                .toList();
        assertThat(named).isNotEmpty().allSatisfy(name -> assertThat(settings).contains("`" + name + "`"));
    }
}
