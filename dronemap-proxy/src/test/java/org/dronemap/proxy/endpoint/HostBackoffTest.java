package org.dronemap.proxy.endpoint;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.link.ClientHost;
import org.junit.jupiter.api.Test;

/** Who was cut again and again waits, and nobody for ever. */
class HostBackoffTest {
    private static final ClientHost HOST = new ClientHost("7f000001");
    private final HostBackoff cuts = new HostBackoff(Duration.ofSeconds(4));

    private long pauseMillis(ClientHost host, Duration at) {
        return Duration.ofNanos(cuts.pauseNanos(host, at.toNanos())).toMillis();
    }

    @Test
    void pausesGrowToTheLongestAfterSomeThatAreFree() {
        List<Long> pauses = new ArrayList<>();
        for (int cut = 0; cut < 11; cut++) {
            cuts.add(HOST, 0);
            pauses.add(pauseMillis(HOST, Duration.ZERO));
        }
        assertThat(pauses).containsExactly(0L, 0L, 0L, 125L, 250L, 500L, 1_000L, 2_000L, 4_000L, 4_000L, 4_000L);
        for (int cut = 0; cut < 100; cut++) {
            cuts.add(HOST, 0);
        }
        assertThat(pauseMillis(HOST, Duration.ZERO)).isEqualTo(4_000);
    }

    @Test
    void concernNobodyElseAndAreForgottenAfterAMinute() {
        for (int cut = 0; cut < 20; cut++) {
            cuts.add(HOST, 0);
        }
        assertThat(pauseMillis(new ClientHost("7f000002"), Duration.ZERO)).isZero();
        assertThat(pauseMillis(HOST, Duration.ofSeconds(60))).isEqualTo(4_000);
        assertThat(pauseMillis(HOST, Duration.ofSeconds(61))).isZero();
        cuts.add(HOST, Duration.ofSeconds(61).toNanos());
        assertThat(pauseMillis(HOST, Duration.ofSeconds(61))).isZero();
    }
}
