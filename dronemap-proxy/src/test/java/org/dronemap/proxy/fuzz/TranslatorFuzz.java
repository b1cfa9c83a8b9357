package org.dronemap.proxy.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dronemap.core.drone.Position;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.mavlink.translate.AutopilotAdapter;
import org.dronemap.proxy.mavlink.translate.TelemetryTranslator;
import org.dronemap.proxy.mavlink.translate.VehicleStatus;

/** Every known message with any payload through every autopilot's translator; what comes out must make sense. */
final class TranslatorFuzz {
    private static final int[] AUTOPILOTS = {3, 12, 0, 8, 255};
    private static final int WARM_UP = 5_000;

    private final List<TelemetryTranslator> translators = new ArrayList<>();
    private final String name;
    private long now = 1_000_000_000L;

    private TranslatorFuzz(Random random, String name) {
        this.name = name;
        for (int autopilot : AUTOPILOTS) {
            int type = random.nextInt(45);
            Heartbeat heartbeat = new Heartbeat(type, autopilot, 81, random.nextInt(), 4, 3);
            translators.add(
                    new TelemetryTranslator(AutopilotAdapter.of(heartbeat), new VehicleStatus(type, 0), this::look));
        }
    }

    static long run(FuzzBudget budget) {
        Random random = budget.random();
        HostileFrames hostile = new HostileFrames(random, 1);
        TranslatorFuzz fuzz = new TranslatorFuzz(random, budget.name());
        HeapGrowthCheck heap = new HeapGrowthCheck();
        long rounds = 0;
        while (budget.isLeft()) {
            byte[] bytes = hostile.next();
            List<Frame> frames = HostileFrames.parsed(bytes);
            if (rounds++ < WARM_UP) {
                fuzz.feed(frames);
            } else {
                SlowInputCheck.check(budget.name(), bytes, () -> fuzz.feed(frames));
            }
        }
        heap.check(budget.name());
        return rounds;
    }

    private void feed(List<Frame> frames) {
        now += 20_000_000L;
        for (TelemetryTranslator translator : translators) {
            frames.forEach(frame -> {
                translator.received(frame, now);
                translator.receivedFromComponent(frame, now);
            });
            translator.advance(now);
        }
    }

    private void look(DroneEvent event) {
        if (event instanceof DroneEvent.PositionReported heard) {
            sensible(heard.position());
        } else if (event instanceof DroneEvent.BatteryReported heard
                && heard.battery().percent() != null) {
            assertThat(heard.battery().percent()).as(name).isBetween(0, 100);
        } else if (event instanceof DroneEvent.AttitudeReported heard && heard.attitude() != null) {
            assertThat(heard.attitude().rollDegrees()).as(name).isFinite();
            assertThat(heard.attitude().yawDegrees()).as(name).isFinite();
        } else if (event instanceof DroneEvent.HomeReported heard && heard.home() != null) {
            assertThat(heard.home().altitudeAmslMeters()).as(name).isFinite();
        }
    }

    private void sensible(Position position) {
        if (position.point() != null) {
            assertThat(position.point().latitudeDegrees()).as(name).isBetween(-90.0, 90.0);
            assertThat(position.point().longitudeDegrees()).as(name).isBetween(-180.0, 180.0);
        }
        if (position.altitudeAmslMeters() != null) {
            assertThat(position.altitudeAmslMeters()).as(name).isFinite();
        }
    }
}
