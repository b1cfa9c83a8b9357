package org.dronemap.core.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class GrantBookTest {
    private static final Instant NOON = Instant.parse("2026-03-04T12:00:00Z");
    private static final OrganisationId RESCUE = new OrganisationId("rescue");
    private static final DroneId ONE = new DroneId("drone-1");
    private static final DroneId TWO = new DroneId("drone-2");
    private static final DroneId THEIRS = new DroneId("drone-3");
    private static final Subject ANN = new Subject.OfUser("ann");
    private static final Subject CREW = new Subject.OfGroup("crew");

    private final AtomicReference<Instant> clock = new AtomicReference<>(NOON);
    private final GrantBook book = new GrantBook(clock::get);
    private final List<Grant> grants = new ArrayList<>();
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
        Principal theirs = new Principal("carl", Role.VIEWER, KeyScope.ALL, null, book.reach(RESCUE, "carl"));
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
        assertThat(book.reach(OrganisationId.HOME, "ann").of(ONE))
                .containsExactlyInAnyOrder(Permission.VIEW, Permission.PLAN, Permission.COMMAND);
        assertThat(book.reach(OrganisationId.HOME, "ann").of(TWO))
                .containsExactlyInAnyOrder(Permission.VIEW, Permission.PLAN, Permission.ADMINISTER);
        assertThat(book.reach(OrganisationId.HOME, "bob").of(ONE)).isEqualTo(Reach.ALL);
    }

    @Test
    void leavesAKeyOfItsOwnerOnlyWhatBothAllow() {
        grant(ANN, new GrantObject.Drones(Set.of(ONE)), Permission.COMMAND);
        keep(Set.of(ANN));
        KeyScope scope = new KeyScope(Set.of(ONE, TWO), Set.of(Permission.PLAN));
        Principal key = new Principal("ann", Role.OPERATOR, scope, "k1", book.reach(OrganisationId.HOME, "ann"));
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

    private Principal ann(Role role) {
        return new Principal("ann", role, KeyScope.ALL, null, book.reach(OrganisationId.HOME, "ann"));
    }

    private void grant(Subject subject, GrantObject object, Permission permission) {
        grant(subject, object, NOON, null, permission);
    }

    private void grant(
            Subject subject, GrantObject object, Instant from, @Nullable Instant until, Permission permission) {
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

    private void keep(Set<Subject> onlyGranted) {
        book.replace(new Holdings(
                List.of(),
                Map.of(THEIRS, RESCUE),
                List.of(new UserGroup("crew", OrganisationId.HOME, "Crew", Set.of("ann"))),
                List.of(new Fleet("trucks", OrganisationId.HOME, "Trucks", Set.of(TWO))),
                grants,
                onlyGranted));
    }
}
