package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.proxy.mavlink.procedure.Conclusion;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ParameterChange;
import org.dronemap.proxy.mavlink.procedure.Sequence;

/** Sets the parameter that says how high a copter flies home, and tells what it was before. */
final class ReturnHeights {
    private ReturnHeights() {}

    /**
     * The parameter of one autopilot.
     *
     * @param perMeter in which parts of a metre it counts
     */
    record Setting(String name, int perMeter, boolean bytewise) {}

    static Exchange set(Cockpit cockpit, SetReturnHeight command, VehicleKind kind, Setting setting) {
        if (kind != VehicleKind.MULTICOPTER && kind != VehicleKind.HELICOPTER) {
            return Maneuvers.refuse("How high this vehicle flies home cannot be set.");
        }
        int wanted = (int) Math.round(command.meters() * setting.perMeter());
        AtomicInteger before = new AtomicInteger(Integer.MIN_VALUE);
        ParameterChange change = new ParameterChange(
                cockpit.target(),
                new ParameterChange.Wanted(
                        setting.name(),
                        old -> {
                            before.compareAndSet(Integer.MIN_VALUE, old);
                            return command.atLeast() ? Math.max(old, wanted) : wanted;
                        },
                        setting.bytewise()));
        return new Sequence(List.of(
                Sequence.Step.of(() -> change),
                Sequence.Step.of(() -> new Conclusion(() -> {
                    double old = before.get();
                    double now = command.atLeast() ? Math.max(old, wanted) : wanted;
                    cockpit.news()
                            .accept(new DroneEvent.ReturnHeightSet(
                                    new ReturnHeight(now / setting.perMeter(), old / setting.perMeter())));
                    return new Outcome.Succeeded();
                }))));
    }
}
