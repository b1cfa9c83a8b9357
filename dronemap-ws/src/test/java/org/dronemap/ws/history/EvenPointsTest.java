package org.dronemap.ws.history;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TimeRange;
import org.junit.jupiter.api.Test;

class EvenPointsTest {
    private static final Instant BEGIN = Instant.parse("2026-05-01T10:00:00Z");
    private static final TimeRange HOUR = new TimeRange(BEGIN, BEGIN.plusSeconds(3600));

    @Test
    void keepsAllThatAreNoMoreThanAskedForHoweverCloseTogether() {
        List<Instant> close = times(Duration.ofMillis(200), 300);

        assertThat(chosen(close, 300)).containsExactlyElementsOf(close);
        assertThat(chosen(close, 5000)).containsExactlyElementsOf(close);
    }

    @Test
    void choosesEvenlyWhenThereAreMore() {
        List<Instant> each = times(Duration.ofSeconds(1), 3600);

        List<Instant> chosen = chosen(each, 60);

        assertThat(chosen).hasSize(60);
        assertThat(chosen).containsExactlyElementsOf(times(Duration.ofMinutes(1), 60));
    }

    @Test
    void choosesNoMoreThanAskedForWhereTheyAreUneven() {
        List<Instant> uneven = Stream.concat(
                        times(Duration.ofMillis(200), 500).stream(),
                        times(Duration.ofSeconds(100), 36).stream().filter(at -> at.isAfter(BEGIN.plusSeconds(100))))
                .toList();

        assertThat(chosen(uneven, 50)).hasSizeBetween(10, 50).isSorted();
    }

    private static List<Instant> times(Duration apart, int count) {
        return IntStream.range(0, count)
                .mapToObj(i -> BEGIN.plus(apart.multipliedBy(i)))
                .toList();
    }

    private static List<Instant> chosen(List<Instant> times, int most) {
        EvenPoints points = new EvenPoints(HOUR, most);
        times.forEach(at -> points.add(point(at)));
        return points.chosen().stream().map(TelemetryPoint::at).toList();
    }

    private static TelemetryPoint point(Instant at) {
        return new TelemetryPoint(
                new DroneId("drone"),
                at,
                null,
                null,
                null,
                null,
                null,
                LinkState.LIVE,
                LinkQuality.UNKNOWN,
                null,
                null,
                null,
                null);
    }
}
