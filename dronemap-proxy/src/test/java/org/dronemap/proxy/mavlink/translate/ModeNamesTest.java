package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeObserver;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The names that ground stations in wide use show, both ways; the table is in modes.txt. */
class ModeNamesTest {
    record Known(int autopilot, int type, long customMode, String name) {
        Heartbeat heartbeat() {
            return new Heartbeat(type, autopilot, 0x51, customMode, 3, 3);
        }
    }

    static Stream<Known> known() {
        InputStream in = ModeNamesTest.class.getResourceAsStream("modes.txt");
        if (in == null) {
            throw new IllegalStateException("modes.txt is missing");
        }
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.US_ASCII))) {
            List<Known> all = lines.lines()
                    .filter(line -> !line.startsWith("#"))
                    .map(line -> line.split(" ", -1))
                    .map(p -> new Known(Integer.parseInt(p[0]), Integer.parseInt(p[1]), Long.parseLong(p[2]), p[3]))
                    .toList();
            return all.stream();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @ParameterizedTest
    @MethodSource("known")
    void showsTheNameAndSetsItByName(Known known) {
        AutopilotAdapter autopilot = AutopilotAdapter.of(known.heartbeat());
        assertThat(autopilot.modeName(known.heartbeat())).isEqualTo(known.name());
        assertThat(autopilot.modes()).contains(known.name());

        VehicleStatus status = new VehicleStatus(known.type(), 0);
        TestWire wire = new TestWire();
        wire.peer((w, message) -> {
            CommandLong command = (CommandLong) message;
            long custom = known.autopilot() == 12
                    ? (long) command.param2() << 16 | (long) command.param3() << 24
                    : (long) command.param2();
            assertThat(command.command()).isEqualTo(176);
            assertThat(custom).isEqualTo(known.customMode());
            status.heartbeat(known.heartbeat(), known.name());
            w.answer(new CommandAck(176, 0, 0, 0, 255, 190));
        });
        ParameterTable parameters = new ParameterTable(autopilot, event -> {});
        CommandContext cockpit = new CommandContext(
                status, parameters, wire.target(), ExchangeObserver.NONE, event -> {}, items -> {}, warning -> {});
        Exchange exchange = autopilot.exchangeFor(new Command.SetMode(known.name()), cockpit);
        assertThat(wire.runWhole(exchange)).isEqualTo(new Outcome.Succeeded());
    }

    @Test
    void showsAModeWithoutANameByItsNumber() {
        Heartbeat copter = new Heartbeat(2, 3, 1, 42, 3, 3);
        assertThat(AutopilotAdapter.of(copter).modeName(copter)).isEqualTo("Mode(42)");
        Heartbeat old = new Heartbeat(2, 3, 0x50, 0, 3, 3);
        assertThat(AutopilotAdapter.of(old).modeName(old)).isEqualTo("Mode(0x00000050)");
    }
}
