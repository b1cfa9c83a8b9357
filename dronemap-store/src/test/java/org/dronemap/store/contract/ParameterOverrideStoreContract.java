package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.ParameterOverrideStore;
import org.dronemap.core.drone.ParameterOverrides;
import org.dronemap.core.parameter.OverriddenParameter;
import org.junit.jupiter.api.Test;

/** What every {@link ParameterOverrideStore} keeps to. */
public abstract class ParameterOverrideStoreContract {
    private static final Instant THEN = Instant.parse("2026-03-04T05:06:07.123456Z");
    private static final DroneId ONE = new DroneId("copter-1");
    private static final DroneId OTHER = new DroneId("copter-2");

    /** Without anything, and without any drone. */
    protected abstract ParameterOverrideStore emptyStore();

    @Test
    void keepsTheNewestOfEachDroneExactlyAndDroneOrNot() {
        ParameterOverrideStore store = emptyStore();
        ParameterOverrides first = new ParameterOverrides(
                ONE,
                "Falcon",
                THEN,
                15.25,
                false,
                List.of(
                        new OverriddenParameter("FS_GCS_ENABLE", 0, 1),
                        new OverriddenParameter("FS_OPTIONS", -2147483648, 18, 18),
                        new OverriddenParameter("RTL_RETURN_ALT", 0.1f, 60.300000000000004)));
        ParameterOverrides other = new ParameterOverrides(OTHER, "Kite", THEN, null, false, List.of());

        store.save(other);
        store.save(first);
        assertThat(store.all()).containsExactly(first, other);

        store.save(first.asWritten(true));
        assertThat(store.all()).containsExactly(first.asWritten(true), other);

        store.delete(ONE);
        store.delete(ONE);
        assertThat(store.all()).containsExactly(other);
    }
}
