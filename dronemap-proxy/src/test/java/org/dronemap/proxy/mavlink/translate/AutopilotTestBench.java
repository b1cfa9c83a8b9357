package org.dronemap.proxy.mavlink.translate;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.ParamValue;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeObserver;
import org.dronemap.proxy.mavlink.procedure.MissionDownload;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.jspecify.annotations.Nullable;

/** A cockpit before a wire in memory: carries one command out after another as the autopilot's adapter plans it. */
final class AutopilotTestBench {
    static final Heartbeat ARDUCOPTER = new Heartbeat(2, 3, 81, 0, 3, 3);
    static final Heartbeat PX4 = new Heartbeat(2, 12, 81, 4 << 16 | 3 << 24, 3, 3);

    final TestWire wire = new TestWire();
    final VehicleStatus status;
    final List<String> progress = new ArrayList<>();
    final List<DroneEvent> news = new ArrayList<>();
    private final AutopilotAdapter autopilot;
    final List<String> warnings = new ArrayList<>();
    private final CommandContext cockpit;
    private final ParameterTable parameters;

    AutopilotTestBench(Heartbeat heartbeat) {
        autopilot = AutopilotAdapter.of(heartbeat);
        status = new VehicleStatus(heartbeat.type(), 0);
        status.heartbeat(heartbeat, autopilot.modeName(heartbeat));
        ExchangeObserver observer = new ExchangeObserver() {
            @Override
            public void progress(int done, int total) {
                progress.add(done + "/" + total);
            }
        };
        parameters = new ParameterTable(autopilot, event -> {});
        cockpit = new CommandContext(
                status, parameters, wire.target(), observer, news::add, this::missionRead, warnings::add);
    }

    /** The vehicle says one of its parameters. */
    void told(ParamValue value) {
        parameters.received(wire.frame(value));
    }

    private void missionRead(MissionDownload read) {
        status.missionRead(read.items());
    }

    @Nullable
    Outcome perform(Command command) {
        return perform(command, 120);
    }

    @Nullable
    Outcome perform(Command command, double seconds) {
        Exchange exchange = autopilot.exchangeFor(command, cockpit);
        exchange.start(wire.now());
        return wire.run(exchange, seconds);
    }
}
