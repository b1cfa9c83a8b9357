package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.ws.testserver.SuccessfulCalls;
import org.dronemap.ws.testserver.TestHttpClient;
import org.junit.jupiter.api.Test;

/**
 * Carries out all that the running server exposes and that may change something while nothing can be written: what needs
 * to write is answered 503 with a sentence, and can be done once there is room again.
 */
class FullDiskTest extends SuccessfulCallTrial {
    private static final String LATER = "Try again later.";
    /** Who has control decides on what is safe, also when nothing can be written. */
    private static final String IN_FORCE = "Control has changed as you asked, but that could not be written down";

    @Test
    void eachOperationThatCannotBeWrittenDownSaysSoAndCanBeRepeated() {
        List<String> wrong = new ArrayList<>();
        int refused = 0;
        for (String operation : faces.rest()) {
            Optional<SuccessfulCalls.PreparedCall> deed = change(operation);
            if (deed.isEmpty()) {
                continue;
            }
            int before = house.stores().refused();
            house.stores().full();
            TestHttpClient.Answer answer = deed.get().make();
            house.stores().on();
            boolean writes = house.stores().refused() > before;
            String told = operation + " is answered " + answer.status() + " "
                    + answer.raw().body();
            if (answer.status() >= 500 && answer.status() != 503) {
                wrong.add(told);
            } else if (answer.status() == 503) {
                refused++;
                TestHttpClient.Answer again = deed.get().make();
                boolean right = answer.text("detail").startsWith(IN_FORCE)
                        || (answer.text("detail").endsWith(LATER) && again.status() < 400);
                if (!right) {
                    wrong.add(told + ", and then " + again.status() + " "
                            + again.raw().body());
                }
            } else if (writes && !answer.raw().body().contains(LATER)) {
                wrong.add(told + " though it was not written");
            }
        }
        assertThat(wrong).isEmpty();
        assertThat(refused).isGreaterThan(50);
    }

    /** Empty for what only looks. */
    private Optional<SuccessfulCalls.PreparedCall> change(String operation) {
        boolean changes = !operation.startsWith("GET ") || operation.endsWith("/oidc/callback");
        return changes ? deed(operation) : Optional.empty();
    }
}
