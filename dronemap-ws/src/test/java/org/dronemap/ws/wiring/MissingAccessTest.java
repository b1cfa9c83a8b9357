package org.dronemap.ws.wiring;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.dronemap.ws.http.FallbackErrorController;
import org.dronemap.ws.server.StartFailureMessage;
import org.dronemap.ws.violation.HandlerViolations;
import org.junit.jupiter.api.Test;
import org.springframework.boot.autoconfigure.EnableAutoConfiguration;
import org.springframework.boot.builder.SpringApplicationBuilder;
import org.springframework.context.ConfigurableApplicationContext;
import org.springframework.context.annotation.Import;

/** A web server of which a handler does not say who may call it is not there at all. */
class MissingAccessTest {
    /** The web server without our faces. */
    @EnableAutoConfiguration
    @Import({AccessConfiguration.class, FallbackErrorController.class})
    static class Bare {}

    @Test
    void keepsTheServerFromStarting() {
        assertThatThrownBy(() -> start(HandlerViolations.Forgetful.class))
                .hasMessage(
                        "The handler org.dronemap.ws.violation.HandlerViolations$Forgetful.forgotten has no @Access; say"
                                + " there who may call it, and what it is about.")
                .satisfies(failure ->
                        assertThat(StartFailureMessage.sentence(failure)).contains("Forgetful.forgotten"));
    }

    @Test
    void letsItStartWhereAllSaySo() {
        try (ConfigurableApplicationContext server = start(HandlerViolations.Careful.class)) {
            assertThat(server.isRunning()).isTrue();
        }
    }

    private static ConfigurableApplicationContext start(Class<?> controller) {
        return new SpringApplicationBuilder(Bare.class, controller)
                .properties("server.port=0", "server.address=127.0.0.1")
                .registerShutdownHook(false)
                .run();
    }
}
