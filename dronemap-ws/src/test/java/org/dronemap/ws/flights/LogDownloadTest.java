package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.time.Duration;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.LinkState;
import org.dronemap.mavlink.message.LogData;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkTap;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.log.OnboardLogService;
import org.dronemap.ws.log.OnboardLogsView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.junit.jupiter.api.Test;

/** Logs on board: listed, fetched over a link that breaks in the middle, saved byte for byte. */
class LogDownloadTest {
    private static final int SIZE = 100_000;
    private static final LabVehicleLink.Quality LOSSY =
            new LabVehicleLink.Quality(0.1, Duration.ofMillis(20), Duration.ZERO);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);
    private final OnboardLogService logs = lab.server().logs();

    private byte[] file(LabDrone drone) throws IOException {
        return Files.readAllBytes(logs.file(ann.principal(), drone.id().value(), 2));
    }

    /** As the vehicle itself said it, piece by piece, whether it arrived or not. */
    private static byte[] said(LinkTap tap) {
        byte[] all = new byte[SIZE];
        for (LogData piece : tap.said(LogData.ID, LogData::decode)) {
            for (int at = 0; at < piece.count(); at++) {
                all[(int) piece.ofs() + at] = (byte) piece.data()[at];
            }
        }
        return all;
    }

    private int came(CommandView fetching) {
        CommandView.ProgressView progress = ann.now(fetching).progress();
        return progress == null ? 0 : progress.done();
    }

    private static void assertConflict(ThrowingCallable call) {
        assertThatThrownBy(call)
                .isInstanceOfSatisfying(
                        Rejection.class, refused -> assertThat(refused.kind()).isEqualTo(RejectionKind.CONFLICT));
    }

    @Test
    void aLogGoesOverWithABreakInTheMiddle() throws IOException {
        try (lab) {
            LabDrone drone = lab.copter();
            String id = drone.id().value();
            assertThat(logs.logs(ann.principal(), id).logs()).isNull();
            ann.succeeds(logs.refresh(ann.caller(), id));
            assertThat(logs.logs(ann.principal(), id).logs())
                    .extracting(OnboardLogsView.LogView::sizeBytes)
                    .containsExactly(12_345L, (long) SIZE);
            assertConflict(() -> logs.file(ann.principal(), id, 2));

            LinkTap tap = drone.wire().tap();
            drone.wire().is(LOSSY);
            CommandView fetching = logs.download(ann.caller(), id, 2);
            lab.until("some of it came", Duration.ofSeconds(30), () -> came(fetching) > 10_000);
            assertThat(ann.now(fetching).outcome()).isNull();
            drone.wire().cut();
            lab.until(
                    "the cut is felt",
                    Duration.ofSeconds(10),
                    () -> drone.state().link().state() != LinkState.LIVE);
            drone.wire().mend();
            drone.wire().is(LabVehicleLink.Quality.GOOD);
            ann.succeeds(fetching);
            assertConflict(() -> logs.download(ann.caller(), id, 2));

            // The log is always the same bytes: fetched anew, over a good link, it must be equal.
            byte[] first = file(drone);
            assertThat(first).hasSize(SIZE).isEqualTo(said(tap));
            logs.remove(ann.caller(), id, 2);
            assertConflict(() -> logs.file(ann.principal(), id, 2));
            ann.succeeds(logs.download(ann.caller(), id, 2));
            assertThat(file(drone)).isEqualTo(first);
            assertThat(logs.logs(ann.principal(), id).logs().get(1).here()).isTrue();
        }
    }
}
