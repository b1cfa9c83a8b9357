package org.dronemap.core.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class KeyRightsTest {
    private static final int PAIRS = 10_000;
    private static final Instant NOW = Instant.parse("2026-01-01T00:00:00Z");
    private static final List<DroneId> DRONES =
            List.of(new DroneId("d1"), new DroneId("d2"), new DroneId("d3"), new DroneId("d4"));

    private final Random random = new Random(41);

    @Test
    void neverLetAKeyDoWhatTheOneItWasMadeFromMayNot() {
        int within = 0;
        for (int pair = 0; pair < PAIRS; pair++) {
            KeyRights parent = any();
            KeyRights child = random.nextBoolean() ? any() : lessThan(parent);
            if (child.beyond(parent).isEmpty()) {
                within++;
                assertThat(allowedOnlyTo(child, parent))
                        .as("%s made from %s", child, parent)
                        .isZero();
            }
        }
        assertThat(within).as("pairs in which the child was let pass").isBetween(PAIRS / 4, PAIRS * 3 / 4);
    }

    @Test
    void refuseAKeyOnlyForSomethingThatItWouldAddOrMightAdd() {
        for (int pair = 0; pair < PAIRS; pair++) {
            KeyRights parent = any();
            assertThat(lessThan(parent).beyond(parent)).isEmpty();
            assertThat(parent.beyond(parent)).isEmpty();
        }
    }

    @Test
    void sayWhatGoesBeyond() {
        KeyRights parent = new KeyRights(
                Role.OPERATOR, new KeyScope(Set.of(DRONES.get(0)), Set.of(Permission.COMMAND)), NOW.plusSeconds(60));

        assertThat(new KeyRights(Role.ADMINISTRATOR, parent.scope(), parent.expiresAt()).beyond(parent))
                .contains(KeyRights.Excess.ROLE);
        assertThat(new KeyRights(Role.OPERATOR, new KeyScope(null, Set.of()), parent.expiresAt()).beyond(parent))
                .contains(KeyRights.Excess.DRONES);
        assertThat(new KeyRights(Role.OPERATOR, new KeyScope(Set.of(), Set.of(Permission.PLAN)), parent.expiresAt())
                        .beyond(parent))
                .contains(KeyRights.Excess.PERMISSIONS);
        assertThat(new KeyRights(Role.OPERATOR, parent.scope(), null).beyond(parent))
                .contains(KeyRights.Excess.EXPIRY);
    }

    private int allowedOnlyTo(KeyRights child, KeyRights parent) {
        int more = 0;
        for (Role needed : Role.values()) {
            for (DroneId drone : DRONES) {
                for (int second = -1; second <= 4; second++) {
                    Instant then = NOW.plusSeconds(second);
                    if (child.permit(needed, drone, then) && !parent.permit(needed, drone, then)) {
                        more++;
                    }
                }
            }
        }
        return more;
    }

    private KeyRights any() {
        return new KeyRights(
                Role.values()[random.nextInt(Role.values().length)],
                new KeyScope(random.nextInt(3) == 0 ? null : some(new HashSet<>(DRONES)), some(all())),
                random.nextInt(3) == 0 ? null : NOW.plusSeconds(random.nextInt(4)));
    }

    private KeyRights lessThan(KeyRights parent) {
        Set<DroneId> drones = parent.scope().drones();
        return new KeyRights(
                Role.values()[random.nextInt(parent.role().ordinal() + 1)],
                new KeyScope(
                        drones == null && random.nextBoolean()
                                ? null
                                : some(drones == null ? new HashSet<>(DRONES) : new HashSet<>(drones)),
                        some(new HashSet<>(parent.scope().permissions()))),
                earlier(parent.expiresAt()));
    }

    private @Nullable Instant earlier(@Nullable Instant end) {
        if (end == null) {
            return random.nextBoolean() ? null : NOW.plusSeconds(random.nextInt(4));
        }
        return end.minusSeconds(random.nextInt(2));
    }

    private <T> Set<T> some(Set<T> of) {
        of.removeIf(each -> random.nextBoolean());
        return of;
    }

    private static Set<Permission> all() {
        return new HashSet<>(EnumSet.allOf(Permission.class));
    }
}
