package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.access.Fleet;
import org.dronemap.core.access.Gift;
import org.dronemap.core.access.Grant;
import org.dronemap.core.access.GrantObject;
import org.dronemap.core.access.GrantStore;
import org.dronemap.core.access.GrantSubject;
import org.dronemap.core.access.OrganisationDirectory;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.UserGroup;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.Organisation;
import org.dronemap.core.organisation.OrganisationId;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link GrantStore} keeps to. */
public abstract class GrantStoreContract {
    /** Who is there in an empty store. */
    protected static final List<String> USERS = List.of("ann", "bob");

    protected static final Organisation RESCUE =
            new Organisation(new OrganisationId("rescue"), "Mountain rescue", Instant.parse("2026-03-04T05:06:07Z"));

    private static final Instant NOON = Instant.parse("2026-03-04T12:00:00.25Z");
    private static final DroneId ONE = new DroneId("drone-1");
    private static final DroneId TWO = new DroneId("drone-2");

    private GrantStore store;

    /** A store that knows the {@link #USERS} and nothing else. */
    protected abstract GrantStore emptyStore();

    @BeforeEach
    void open() {
        store = emptyStore();
    }

    @Test
    void holdsNothingAtFirst() {
        assertThat(store.directory()).isEqualTo(OrganisationDirectory.NONE);
    }

    @Test
    void keepsOrganisationsByName() {
        Organisation survey = new Organisation(new OrganisationId("survey"), "land survey", NOON);
        store.save(RESCUE);
        store.save(survey);
        assertThat(store.directory().organisations()).containsExactly(survey, RESCUE);

        Organisation renamed = new Organisation(RESCUE.id(), "Air rescue", RESCUE.madeAt());
        store.save(renamed);
        assertThat(store.directory().organisations()).containsExactly(renamed, survey);
    }

    @Test
    void forgetsWhatBelongsToAnOrganisationWithIt() {
        store.save(RESCUE);
        store.save(new UserGroup("g1", RESCUE.id(), "crew", Set.of("ann")));
        store.save(new Fleet("f1", RESCUE.id(), "trucks", Set.of(ONE)));
        store.save(group("g2", "others", "bob"));
        store.setOnlyGranted(new GrantSubject.OfGroup("g1"), true);
        store.add(grant("a", RESCUE.id(), new GrantSubject.OfUser("ann"), new GrantObject.Everything()));

        assertThat(store.deleteOrganisation(RESCUE.id())).isTrue();
        assertThat(store.deleteOrganisation(RESCUE.id())).isFalse();

        assertThat(store.directory())
                .isEqualTo(new OrganisationDirectory(
                        List.of(),
                        Map.of(),
                        List.of(group("g2", "others", "bob")),
                        List.of(),
                        List.of(),
                        List.of(),
                        Set.of()));
    }

    @Test
    void remembersThatADroneWasGivenAndWhoseItIs() {
        store.save(RESCUE);
        Gift there = new Gift(ONE, "Kite", OrganisationId.HOME, RESCUE.id(), NOON, true);
        Gift back = new Gift(ONE, "Kestrel", RESCUE.id(), OrganisationId.HOME, NOON.plusSeconds(1), false);

        store.give(there);
        assertThat(store.directory().owners()).isEqualTo(Map.of(ONE, RESCUE.id()));
        store.give(back);

        assertThat(store.directory().owners()).isEqualTo(Map.of(ONE, OrganisationId.HOME));
        assertThat(store.directory().gifts()).containsExactly(there, back);
        store.deleteOrganisation(RESCUE.id());
        assertThat(store.directory().gifts()).containsExactly(there, back);
    }

    @Test
    void keepsToWhomADroneBelongsAlsoWhenItsOrganisationIsGone() {
        store.save(RESCUE);
        store.assign(ONE, RESCUE.id());
        store.assign(TWO, RESCUE.id());
        store.assign(TWO, OrganisationId.HOME);
        store.deleteOrganisation(RESCUE.id());
        assertThat(store.directory().owners()).isEqualTo(Map.of(ONE, RESCUE.id(), TWO, OrganisationId.HOME));
    }

    @Test
    void replacesTheMembersOfAGroup() {
        store.save(group("g1", "crew", "ann"));
        store.save(group("g2", "Alone"));
        store.save(group("g1", "crew of two", "ann", "bob"));
        assertThat(store.directory().groups())
                .containsExactly(group("g2", "Alone"), group("g1", "crew of two", "ann", "bob"));
        store.save(group("g1", "nobody"));
        assertThat(store.directory().groups()).containsExactly(group("g2", "Alone"), group("g1", "nobody"));
    }

    @Test
    void forgetsWhatAGroupWasGrantedWithTheGroup() {
        store.save(group("g1", "crew", "ann"));
        store.setOnlyGranted(new GrantSubject.OfGroup("g1"), true);
        store.add(grant("a", new GrantSubject.OfGroup("g1"), new GrantObject.Everything()));

        assertThat(store.deleteGroup("g1")).isTrue();
        assertThat(store.deleteGroup("g1")).isFalse();

        assertThat(store.directory()).isEqualTo(OrganisationDirectory.NONE);
    }

    @Test
    void replacesAFleetAndForgetsItsGrantsWithIt() {
        store.save(new Fleet("f1", OrganisationId.HOME, "trucks", Set.of(ONE, TWO)));
        Fleet smaller = new Fleet("f1", OrganisationId.HOME, "truck", Set.of(TWO));
        store.save(smaller);
        store.save(new Fleet("f2", OrganisationId.HOME, "none", Set.of()));
        assertThat(store.directory().fleets())
                .containsExactly(new Fleet("f2", OrganisationId.HOME, "none", Set.of()), smaller);
        store.add(grant("a", new GrantSubject.OfUser("ann"), new GrantObject.OfFleet("f1")));

        assertThat(store.deleteFleet("f1")).isTrue();
        assertThat(store.deleteFleet("f1")).isFalse();

        assertThat(store.directory().grants()).isEmpty();
    }

    @Test
    void givesBackEveryKindOfGrant() {
        store.save(RESCUE);
        store.save(group("g1", "crew", "ann"));
        store.save(new Fleet("f1", OrganisationId.HOME, "trucks", Set.of(ONE)));
        Grant all = grant("a", RESCUE.id(), new GrantSubject.OfUser("ann"), new GrantObject.Everything());
        Grant some = grant("b", new GrantSubject.OfGroup("g1"), new GrantObject.Drones(Set.of(ONE, TWO)));
        Grant fleet = new Grant(
                "c",
                OrganisationId.HOME,
                new GrantSubject.OfUser("bob"),
                new GrantObject.OfFleet("f1"),
                EnumSet.allOf(Permission.class),
                NOON,
                null,
                "root",
                NOON.plusSeconds(1));
        Grant virtual = grant("d", new GrantSubject.OfUser("ann"), new GrantObject.Virtual());
        store.add(virtual);
        store.add(fleet);
        store.add(some);
        store.add(all);
        assertThat(store.directory().grants()).containsExactly(all, some, virtual, fleet);

        assertThat(store.deleteGrant("b")).isTrue();
        assertThat(store.deleteGrant("b")).isFalse();

        assertThat(store.directory().grants()).containsExactly(all, virtual, fleet);
    }

    @Test
    void knowsWhoSeesOnlyWhatWasGranted() {
        GrantSubject ann = new GrantSubject.OfUser("ann");
        GrantSubject crew = new GrantSubject.OfGroup("g1");
        store.save(group("g1", "crew"));
        store.setOnlyGranted(ann, true);
        store.setOnlyGranted(ann, true);
        store.setOnlyGranted(crew, true);
        assertThat(store.directory().onlyGranted()).containsExactlyInAnyOrder(ann, crew);
        store.setOnlyGranted(ann, false);
        store.setOnlyGranted(ann, false);
        assertThat(store.directory().onlyGranted()).containsExactly(crew);
    }

    @Test
    void forgetsAUser() {
        store.save(group("g1", "crew", "ann", "bob"));
        store.add(grant("a", new GrantSubject.OfUser("ann"), new GrantObject.Everything()));
        store.add(grant("b", new GrantSubject.OfUser("bob"), new GrantObject.Everything()));
        store.setOnlyGranted(new GrantSubject.OfUser("ann"), true);

        store.forgetUser("ann");

        assertThat(store.directory().groups()).containsExactly(group("g1", "crew", "bob"));
        assertThat(store.directory().grants()).extracting(Grant::id).containsExactly("b");
        assertThat(store.directory().onlyGranted()).isEmpty();
    }

    protected static UserGroup group(String id, String name, String... members) {
        return new UserGroup(id, OrganisationId.HOME, name, Set.of(members));
    }

    protected static Grant grant(String id, GrantSubject subject, GrantObject object) {
        return grant(id, OrganisationId.HOME, subject, object);
    }

    private static Grant grant(String id, OrganisationId organisation, GrantSubject subject, GrantObject object) {
        return new Grant(
                id, organisation, subject, object, Set.of(Permission.PLAN), NOON, NOON.plusSeconds(60), "root", NOON);
    }
}
