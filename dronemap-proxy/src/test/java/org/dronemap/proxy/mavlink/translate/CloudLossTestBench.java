package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.ParameterOverrideRecorder;
import org.dronemap.core.command.RestoreParameters;
import org.dronemap.core.command.SetCloudLossAction;
import org.dronemap.core.parameter.OverriddenParameter;
import org.dronemap.core.parameter.ParameterValue;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.ParamValue;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.jspecify.annotations.Nullable;

/** A vehicle that tells and takes its parameters, and who keeps what its owner had set. */
abstract class CloudLossTestBench {
    static final Outcome DONE = new Outcome.Succeeded();
    static final Heartbeat PLANE = new Heartbeat(1, 3, 81, 0, 3, 3);
    static final Heartbeat ROVER = new Heartbeat(10, 3, 81, 0, 3, 3);
    static final Heartbeat SUB = new Heartbeat(12, 3, 81, 0, 3, 3);
    static final int INT32 = 6;
    static final int REAL32 = 9;

    /** As the vehicle holds them; those of PX4 that are whole numbers travel as their bits. */
    final Map<String, Double> held = new LinkedHashMap<>();

    final Map<String, Integer> types = new HashMap<>();
    final TestOverrideRecorder keeper = new TestOverrideRecorder();
    boolean bytewise;
    int powerLostAfter = Integer.MAX_VALUE;
    int sets;

    @Nullable
    AutopilotTestBench bench;

    /** Remembers what it was told, and says when that is kept. */
    static final class TestOverrideRecorder implements ParameterOverrideRecorder {
        CompletableFuture<Void> kept = CompletableFuture.completedFuture(null);
        double meters = Double.NaN;
        /** What its owner had, in m, as it was asked for. */
        double asked = Double.NaN;

        final List<ParameterValue> left = new ArrayList<>();
        private @Nullable OverridePlan plan;

        @Override
        public double returnMeters(double owners) {
            asked = owners;
            return Double.isNaN(meters) ? owners : meters;
        }

        @Override
        public CompletableFuture<Void> keep(OverridePlan found) {
            plan = found;
            return kept;
        }

        @Override
        public void skipped(List<ParameterValue> shown) {
            left.addAll(shown);
        }

        OverridePlan plan() {
            return Objects.requireNonNull(plan);
        }
    }

    void has(String name, int type, double value) {
        held.put(name, value);
        types.put(name, type);
    }

    AutopilotTestBench bench(Heartbeat heartbeat) {
        AutopilotTestBench made = new AutopilotTestBench(heartbeat);
        made.wire.peer(this::vehicle);
        bench = made;
        return made;
    }

    void vehicle(TestWire wire, Message message) {
        if (message instanceof ParamSet set && sets++ < powerLostAfter && held.containsKey(set.paramId())) {
            held.put(set.paramId(), decoded(set.paramId(), set.paramValue()));
            tell(wire, set.paramId());
        } else if (message instanceof ParamRequestRead question
                && sets <= powerLostAfter
                && held.containsKey(question.paramId())) {
            tell(wire, question.paramId());
        }
    }

    void tell(TestWire wire, String name) {
        wire.answer(new ParamValue(name, encoded(name), types.getOrDefault(name, REAL32), 900, 1));
    }

    boolean asBits(String name) {
        return bytewise && types.getOrDefault(name, REAL32) == INT32;
    }

    float encoded(String name) {
        double value = held.getOrDefault(name, 0.0);
        return asBits(name) ? Float.intBitsToFloat((int) value) : (float) value;
    }

    double decoded(String name, float raw) {
        return asBits(name) ? Float.floatToRawIntBits(raw) : raw;
    }

    @Nullable
    Outcome set(OverriddenParameter... kept) {
        return bench().perform(new SetCloudLossAction(20, List.of(kept), keeper));
    }

    @Nullable
    Outcome putBack() {
        return bench().perform(new RestoreParameters(keeper.plan().values(), keeper));
    }

    AutopilotTestBench bench() {
        return Objects.requireNonNull(bench);
    }

    List<String> written() {
        return bench().wire.sent(ParamSet.class).stream()
                .map(ParamSet::paramId)
                .distinct()
                .sorted()
                .toList();
    }

    void isACopter() {
        has("FS_GCS_ENABLE", INT32, 0);
        has("FS_GCS_TIMEOUT", REAL32, 5);
        has("FS_OPTIONS", INT32, 1);
        has("FS_THR_ENABLE", INT32, 1);
        has("RTL_ALT", INT32, 1_500);
        bench(AutopilotTestBench.ARDUCOPTER);
    }

    void isAPlane(double enabled, double action, double seconds) {
        has("FS_GCS_ENABL", INT32, enabled);
        has("FS_LONG_ACTN", INT32, action);
        has("FS_LONG_TIMOUT", REAL32, seconds);
        has("THR_FAILSAFE", INT32, 1);
        has("RTL_AUTOLAND", INT32, 1);
        has("Q_ENABLE", INT32, 0);
        bench(PLANE);
    }

    void isARover() {
        has("FS_GCS_ENABLE", INT32, 0);
        has("FS_GCS_TIMEOUT", REAL32, 5);
        has("FS_ACTION", INT32, 0);
        has("FS_THR_ENABLE", INT32, 1);
        bench(ROVER);
    }

    void isPx4() {
        bytewise = true;
        has("NAV_DLL_ACT", INT32, 0);
        has("COM_DL_LOSS_T", INT32, 10);
        has("COM_DLL_EXCEPT", INT32, 0);
        has("NAV_RCL_ACT", INT32, 2);
        has("RTL_RETURN_ALT", REAL32, 30.5);
        bench(AutopilotTestBench.PX4);
    }

    /** It is set, and then everything is again as it was. */
    void isSetAndPutBack() {
        Map<String, Double> before = Map.copyOf(held);
        assertThat(set()).isEqualTo(DONE);
        assertThat(held).isNotEqualTo(before);
        assertThat(putBack()).isEqualTo(DONE);
        assertThat(held).isEqualTo(before);
        assertThat(keeper.left).isEmpty();
    }
}
