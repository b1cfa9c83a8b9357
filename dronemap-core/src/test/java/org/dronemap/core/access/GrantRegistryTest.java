package org.dronemap.core.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class GrantRegistryTest {
    private static final Instant NOON = Instant.parse("2026-03-04T12:00:00Z");
    private static final OrganisationId RESCUE = new OrganisationId("rescue");
    private static final DroneId ONE = new DroneId("drone-1");
    private static final DroneId TWO = new DroneId("drone-2");
    private static final DroneId THEIRS = new DroneId("drone-3");
    private static final GrantSubject ANN = new GrantSubject.OfUser("ann");
    private static final GrantSubject CREW = new GrantSubject.OfGroup("crew");

    private final AtomicReference<Instant> clock = new AtomicReference<>(NOON);
    private final GrantRegistry book = new GrantRegistry(clock::get);
    private final List<Grant> grants = new ArrayList<>();
    private final List<Gift> gifts = new ArrayList<>();
    private final AtomicInteger ids = new AtomicInteger();

    @Test
    void showsEverybodyTheDronesOfTheirOrganisationByTheirRole() {
        keep(Set.of());
        assertThat(ann(Role.OPERATOR).may(Role.OPERATOR, ONE)).isTrue();
        assertThat(ann(Role.OPERATOR).may(Role.ADMINISTRATOR, ONE)).isFalse();
        assertThat(ann(Role.VIEWER).sees(TWO)).isTrue();
        assertThat(ann(Role.VIEWER).isWhole()).isTrue();
    }

    @Test
    void showsNobodyTheDronesOfAnotherOrganisation() {
        keep(Set.of());
        assertThat(ann(Role.ADMINISTRATOR).sees(THEIRS)).isFalse();
        assertThat(ann(Role.ADMINISTRATOR).may(Role.VIEWER, THEIRS)).isFalse();
        Principal theirs = new Principal("carl", Role.VIEWER, KeyScope.ALL, null, book.permissionsOf(RESCUE, "carl"));
        assertThat(theirs.sees(THEIRS)).isTrue();
        assertThat(theirs.sees(ONE)).isFalse();
    }

    @Test
    void grantsNothingAcrossOrganisations() {
        grant(ANN, new GrantObject.Drones(Set.of(THEIRS)), Permission.COMMAND);
        keep(Set.of(ANN));
        assertThat(ann(Role.ADMINISTRATOR).sees(THEIRS)).isFalse();
    }

    @Test
    void leavesWhoSeesOnlyWhatWasGrantedNothingElse() {
        keep(Set.of(ANN));
        assertThat(ann(Role.ADMINISTRATOR).sees(ONE)).isFalse();
        assertThat(ann(Role.ADMINISTRATOR).may(Role.VIEWER)).isTrue();
        assertThat(ann(Role.ADMINISTRATOR).may(Role.PLANNER)).isFalse();
        assertThat(ann(Role.ADMINISTRATOR).isWhole()).isFalse();
    }

    @Test
    void takesFromTheRoleAndNeverAddsToIt() {
        grant(ANN, new GrantObject.Drones(Set.of(ONE)), Permission.COMMAND);
        keep(Set.of(ANN));
        assertThat(ann(Role.ADMINISTRATOR).may(Role.OPERATOR, ONE)).isTrue();
        assertThat(ann(Role.ADMINISTRATOR).may(Role.PLANNER, ONE)).isFalse();
        assertThat(ann(Role.ADMINISTRATOR).may(Role.ADMINISTRATOR, ONE)).isFalse();
        assertThat(ann(Role.ADMINISTRATOR).sees(TWO)).isFalse();
        assertThat(ann(Role.VIEWER).may(Role.OPERATOR, ONE)).isFalse();
        assertThat(ann(Role.VIEWER).sees(ONE)).isTrue();
    }

    @Test
    void addsGrantsUp() {
        grant(ANN, new GrantObject.Drones(Set.of(ONE)), Permission.COMMAND);
        grant(CREW, new GrantObject.Everything(), Permission.PLAN);
        grant(CREW, new GrantObject.OfFleet("trucks"), Permission.ADMINISTER);
        keep(Set.of(CREW));
        assertThat(book.permissionsOf(OrganisationId.HOME, "ann").of(ONE))
                .containsExactlyInAnyOrder(Permission.VIEW, Permission.PLAN, Permission.COMMAND);
        assertThat(book.permissionsOf(OrganisationId.HOME, "ann").of(TWO))
                .containsExactlyInAnyOrder(Permission.VIEW, Permission.PLAN, Permission.ADMINISTER);
        assertThat(book.permissionsOf(OrganisationId.HOME, "bob").of(ONE)).isEqualTo(EffectivePermissions.ALL);
    }

    @Test
    void leavesAKeyOfItsOwnerOnlyWhatBothAllow() {
        grant(ANN, new GrantObject.Drones(Set.of(ONE)), Permission.COMMAND);
        keep(Set.of(ANN));
        KeyScope scope = new KeyScope(Set.of(ONE, TWO), Set.of(Permission.PLAN));
        Principal key =
                new Principal("ann", Role.OPERATOR, scope, "k1", book.permissionsOf(OrganisationId.HOME, "ann"));
        assertThat(key.permissions(ONE)).containsExactly(Permission.VIEW);
        assertThat(key.permissions(TWO)).isEmpty();
        assertThat(key.may(Role.OPERATOR, ONE)).isFalse();
        assertThat(key.sees(ONE)).isTrue();
    }

    @Test
    void holdsAGrantFromItsBeginningToItsEndForWhoIsThereAlready() {
        grant(
                ANN,
                new GrantObject.Drones(Set.of(ONE)),
                NOON.plusSeconds(60),
                NOON.plusSeconds(120),
                Permission.COMMAND);
        keep(Set.of(ANN));
        Principal ann = ann(Role.OPERATOR);
        assertThat(ann.sees(ONE)).isFalse();
        long before = book.edition();
        clock.set(NOON.plusSeconds(60));
        assertThat(ann.may(Role.OPERATOR, ONE)).isTrue();
        long during = book.edition();
        clock.set(NOON.plusSeconds(120));
        assertThat(ann.sees(ONE)).isFalse();
        assertThat(Set.of(before, during, book.edition())).hasSize(3);
    }

    @Test
    void tellsOfBeginningsAndEndsOnce() {
        grant(ANN, new GrantObject.Everything(), NOON, NOON.plusSeconds(10), Permission.VIEW);
        AtomicInteger told = new AtomicInteger();
        book.onChange(told::incrementAndGet);
        keep(Set.of(ANN));
        book.announce();
        assertThat(told).hasValue(1);
        clock.updateAndGet(now -> now.plus(Duration.ofSeconds(10)));
        book.announce();
        book.announce();
        assertThat(told).hasValue(2);
    }

    @Test
    void forgetsAtOnceWhatIsTakenBack() {
        grant(ANN, new GrantObject.Everything(), Permission.COMMAND);
        keep(Set.of(ANN));
        Principal ann = ann(Role.OPERATOR);
        assertThat(ann.may(Role.OPERATOR, ONE)).isTrue();
        grants.clear();
        keep(Set.of(ANN));
        assertThat(ann.may(Role.OPERATOR, ONE)).isFalse();
        assertThat(ann.sees(ONE)).isFalse();
    }

    @Test
    void lendsDronesThatAreKeptNowhere() {
        keep(Set.of());
        DroneId played = new DroneId("played");
        book.lend(played, RESCUE);
        assertThat(ann(Role.VIEWER).sees(played)).isFalse();
        book.lend(played, OrganisationId.HOME);
        assertThat(ann(Role.VIEWER).sees(played)).isTrue();
    }

    @Test
    void showsNothingOfWhatADroneDidForOthers() {
        gift(OrganisationId.HOME, RESCUE, NOON, false);
        keep(Set.of());
        assertThat(sights(OrganisationId.HOME, -1, 0)).containsExactly(VisibilityLevel.ALL, VisibilityLevel.NONE);
        assertThat(sights(RESCUE, -1, 0)).containsExactly(VisibilityLevel.NONE, VisibilityLevel.ALL);
        assertThat(sights(new OrganisationId("survey"), -1, 0)).containsOnly(VisibilityLevel.NONE);
        assertThat(book.permissionsOf(RESCUE).insight(THEIRS).within(NOON.minusSeconds(5), NOON.plusSeconds(5)))
                .contains(new HistoryVisibility.Period(NOON, NOON.plusSeconds(5), false));
        assertThat(book.permissionsOf(RESCUE).insight(ONE)).isEqualTo(HistoryVisibility.NONE);
    }

    @Test
    void showsWhatWentAlongWithoutNamesAndOnlyWhatTheGiverSaw() {
        gift(OrganisationId.HOME, RESCUE, NOON, false);
        gift(RESCUE, OrganisationId.HOME, NOON.plusSeconds(10), true);
        gift(OrganisationId.HOME, RESCUE, NOON.plusSeconds(20), true);
        keep(Set.of());
        assertThat(sights(OrganisationId.HOME, -1, 5, 15, 25))
                .containsExactly(
                        VisibilityLevel.ALL, VisibilityLevel.WITHOUT_NAMES, VisibilityLevel.ALL, VisibilityLevel.NONE);
        assertThat(sights(RESCUE, -1, 5, 15, 25))
                .containsExactly(
                        VisibilityLevel.WITHOUT_NAMES,
                        VisibilityLevel.ALL,
                        VisibilityLevel.WITHOUT_NAMES,
                        VisibilityLevel.ALL);
        assertThat(book.permissionsOf(OrganisationId.HOME).insight(THEIRS).within(Instant.EPOCH, NOON.plusSeconds(30)))
                .contains(new HistoryVisibility.Period(Instant.EPOCH, NOON.plusSeconds(20), false));
    }

    @Test
    void showsNoPastToWhomTheDroneWasNotGrantedNorThroughAKeyForOthers() {
        gift(OrganisationId.HOME, RESCUE, NOON, false);
        grant(CREW, new GrantObject.Drones(Set.of(ONE)), Permission.VIEW);
        keep(Set.of(ANN));
        assertThat(ann(Role.VIEWER).sight(THEIRS, NOON.minusSeconds(1))).isEqualTo(VisibilityLevel.NONE);
        assertThat(ann(Role.VIEWER).sight(ONE, NOON.minusSeconds(1))).isEqualTo(VisibilityLevel.ALL);
        KeyScope scope = new KeyScope(Set.of(TWO), Set.of());
        Principal key = new Principal("bob", Role.VIEWER, scope, "k1", book.permissionsOf(OrganisationId.HOME, "bob"));
        assertThat(key.sight(THEIRS, NOON.minusSeconds(1))).isEqualTo(VisibilityLevel.NONE);
        assertThat(key.sight(TWO, NOON.minusSeconds(1))).isEqualTo(VisibilityLevel.ALL);
    }

    private List<VisibilityLevel> sights(OrganisationId organisation, int... seconds) {
        return Arrays.stream(seconds)
                .mapToObj(second ->
                        book.permissionsOf(organisation).insight(THEIRS).at(NOON.plusSeconds(second)))
                .toList();
    }

    private void gift(OrganisationId from, OrganisationId to, Instant at, boolean histories) {
        gifts.add(new Gift(THEIRS, "Kite", from, to, at, histories));
    }

    private Principal ann(Role role) {
        return new Principal("ann", role, KeyScope.ALL, null, book.permissionsOf(OrganisationId.HOME, "ann"));
    }

    private void grant(GrantSubject subject, GrantObject object, Permission permission) {
        grant(subject, object, NOON, null, permission);
    }

    private void grant(
            GrantSubject subject, GrantObject object, Instant from, @Nullable Instant until, Permission permission) {
        grants.add(new Grant(
                "g" + ids.incrementAndGet(),
                OrganisationId.HOME,
                subject,
                object,
                Set.of(permission),
                from,
                until,
                "root",
                NOON));
    }

    private void keep(Set<GrantSubject> onlyGranted) {
        book.replace(new OrganisationDirectory(
                List.of(),
                Map.of(THEIRS, RESCUE),
                List.of(new UserGroup("crew", OrganisationId.HOME, "Crew", Set.of("ann"))),
                List.of(new Fleet("trucks", OrganisationId.HOME, "Trucks", Set.of(TWO))),
                grants,
                gifts,
                onlyGranted));
    }
}
